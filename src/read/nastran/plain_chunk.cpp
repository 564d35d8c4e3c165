// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/plain_chunk.hpp"

#include "base/huge_pages.hpp"
#include "read/nastran/plain_elements.hpp"
#include "read/nastran/plain_grids.hpp"
#include "read/nastran/plain_lines.hpp"

#include <algorithm>

namespace feelem::nastran {
namespace {

void make_room(BulkGrids& grids, std::size_t left, std::size_t each) {
    if (grids.ids.size() < grids.ids.capacity()) return;
    grow_by_text(grids.ids, left, each);
    reserve_big(grids.places, grids.ids.capacity());
}

void make_room(BulkElements& elements, std::size_t left, std::size_t each, std::size_t width) {
    if (elements.ids.size() < elements.ids.capacity()) return;
    grow_by_text(elements.ids, left, each);
    const std::size_t more = elements.ids.capacity() - elements.ids.size();
    reserve_big(elements.offsets, elements.ids.capacity());
    reserve_big(elements.nodes, elements.nodes.size() + more * width);
}

}  // namespace

std::size_t PlainCards::read(std::string_view text, std::uint32_t file, std::size_t from, std::size_t stop) {
    grids.clear();
    elements.clear();
    const Read done = read(text, file, from, stop, grids, elements);
    cards = done.cards;
    end = done.end;
    return end;
}

PlainCards::Read PlainCards::read(
    std::string_view text,
    std::uint32_t file,
    std::size_t from,
    std::size_t stop,
    BulkGrids& grids,
    BulkElements& elements
) {
    PlainElements reader(text);
    PlainElement element;
    BulkGrid grid;
    Read done{from, 0};
    while (done.end < stop) {
        const std::size_t at = done.end;
        const bool is_grid = text[at] == 'G';
        const auto next = is_grid           ? read_plain_grid(text, at, grid)
                          : text[at] == 'C' ? reader.read(at, element)
                                            : std::nullopt;
        if (!next) break;
        const std::size_t left = stop - std::min(*next, stop), each = *next - at;
        if (is_grid) {
            make_room(grids, left, each);
            grids.add(grid);
        } else {
            make_room(elements, left, each, element.count);
            elements.add(element, file, at);
        }
        done.end = *next;
        ++done.cards;
    }
    return done;
}

std::size_t PlainCards::start_of_card(std::string_view text, std::size_t at) {
    while (at < text.size()) {
        if (at > 0 && text[at - 1] == '\n' && starts_card(text[at])) return at;
        const std::size_t end = text.find('\n', at);
        if (end == std::string_view::npos) break;
        at = end + 1;
    }
    return text.size();
}

}  // namespace feelem::nastran
