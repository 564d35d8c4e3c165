// SPDX-License-Identifier: Apache-2.0
// The rows of *NODE and *ELEMENT: plain ones many at once and on several threads, all others line by line, in
// the order of the deck.
#pragma once

#include "read/abaqus/deck_lines.hpp"
#include "read/abaqus/plain_rows.hpp"
#include "read/text_chunks.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace feelem::abaqus {

/// `Rows` is PlainNodes or PlainElementRows. `General` reads the row that starts with a line and may go on in
/// further ones: false when that was the last.
template <class Rows, class General>
class KeywordRows {
public:
    KeywordRows(DataLines& lines, Rows& rows, const General& general)
        : lines_(lines), rows_(rows), general_(general) {}

    /// All of them, behind those that are in `rows`.
    void read() {
        while (!ended_) {
            take_plain_rows();
            if (!ended_) take_general_row();
        }
    }

private:
    /// How read_in_text_chunks() reads rows.
    struct Chunks {
        KeywordRows* self;
        DataLines::Ahead ahead;

        std::size_t start(std::size_t at) const { return start_of_row(ahead.text, at); }
        std::size_t read(Rows& chunk, std::size_t from, std::size_t stop) const {
            chunk.begin_like(self->rows_);
            return chunk.read(ahead.text, from, stop);
        }
        void take(const Rows& chunk) const { self->rows_.add(chunk); }
        std::optional<std::size_t> go_on(std::size_t from, std::size_t stop) const {
            return self->go_on(ahead, from, stop);
        }
    };

    void take_general_row() {
        const auto line = lines_.next();
        ended_ = !line || !general_(*line);
    }

    /// As long as they follow each other; threads for those alone of which there are many.
    void take_plain_rows() {
        const DataLines::Ahead ahead = lines_.ahead();
        if (ahead.first == ahead.end) return;
        const std::size_t some = ahead.first + std::min(kTextChunk, ahead.end - ahead.first);
        std::optional<std::size_t> at = rows_.read(ahead.text, ahead.first, some);
        if (*at >= some) {
            at = is_worth_chunks(ahead.end - *at)
                     ? read_in_text_chunks<Rows>(*at, ahead.end, Chunks{this, ahead})
                     : rows_.read(ahead.text, *at, ahead.end);
        }
        if (at) lines_.go_on_at(*at);
    }

    /// Rows of any kind up to `stop`; empty when the lines go on elsewhere or end.
    std::optional<std::size_t> go_on(const DataLines::Ahead& there, std::size_t from, std::size_t stop) {
        for (std::size_t at = from; at < stop;) {
            lines_.go_on_at(at);
            take_general_row();
            if (ended_) return {};
            const DataLines::Ahead ahead = lines_.ahead();
            if (ahead.text.data() != there.text.data() || ahead.end != there.end) return {};
            at = rows_.read(ahead.text, ahead.first, stop);
            if (at >= stop) return at;
        }
        return {};
    }

    DataLines& lines_;
    Rows& rows_;
    const General& general_;
    bool ended_ = false;
};

template <class Rows, class General>
void read_rows(DataLines& lines, Rows& rows, const General& general) {
    KeywordRows<Rows, General>(lines, rows, general).read();
}

}  // namespace feelem::abaqus
