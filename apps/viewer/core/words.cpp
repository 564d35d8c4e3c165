// SPDX-License-Identifier: Apache-2.0
// Words of enumerators, as recordings and messages write them.
#include "viewer/core/snapshot.hpp"

namespace feelem::viewer {

std::string_view word(SenseEvent event) {
    switch (event) {
    case SenseEvent::LimitUp: return "limitUp";
    case SenseEvent::LimitDown: return "limitDown";
    case SenseEvent::Maximum: return "maximum";
    case SenseEvent::Minimum: return "minimum";
    case SenseEvent::NoValue: return "noValue";
    case SenseEvent::BandUp: return "bandUp";
    case SenseEvent::BandDown: return "bandDown";
    case SenseEvent::Enter: return "enter";
    }
    return {};
}

std::string_view word(Pointer pointer) {
    switch (pointer) {
    case Pointer::Mouse: return "mouse";
    case Pointer::Left: return "left";
    case Pointer::Right: return "right";
    case Pointer::Pin: return "pin";
    }
    return {};
}

}  // namespace feelem::viewer
