// SPDX-License-Identifier: Apache-2.0
// Ways from one thread to one other that never make either wait.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace feelem::viewer {

/// The newest of what one thread writes, for one reader: three places, of which each thread holds one.
template <class T>
class Newest {
public:
    /// Writer's side.
    void put(const T& value) {
        places_[writing_] = value;
        writing_ = middle_.exchange(static_cast<std::uint8_t>(writing_ | kIsNew), std::memory_order_acq_rel) &
                   kPlace;
    }
    /// Reader's side; stays valid until the next call.
    const T& get() {
        if (middle_.load(std::memory_order_relaxed) & kIsNew) {
            reading_ = middle_.exchange(reading_, std::memory_order_acq_rel) & kPlace;
        }
        return places_[reading_];
    }

private:
    static constexpr std::uint8_t kPlace = 3, kIsNew = 4;
    std::array<T, 3> places_{};
    std::atomic<std::uint8_t> middle_{1};
    std::uint8_t writing_ = 0, reading_ = 2;
};

/// All that one thread puts in, in order, for one reader; what finds no room is left out.
template <class T>
class Queue {
public:
    explicit Queue(std::size_t size) : places_(size + 1) {}

    /// Writer's side. False: full.
    bool put(const T& value) {
        const std::size_t at = written_.load(std::memory_order_relaxed);
        const std::size_t after = (at + 1) % places_.size();
        if (after == read_.load(std::memory_order_acquire)) return false;
        places_[at] = value;
        written_.store(after, std::memory_order_release);
        return true;
    }
    /// Reader's side.
    std::optional<T> take() {
        const std::size_t at = read_.load(std::memory_order_relaxed);
        if (at == written_.load(std::memory_order_acquire)) return std::nullopt;
        const T value = places_[at];
        read_.store((at + 1) % places_.size(), std::memory_order_release);
        return value;
    }

private:
    std::vector<T> places_;
    std::atomic<std::size_t> written_{0}, read_{0};
};

}  // namespace feelem::viewer
