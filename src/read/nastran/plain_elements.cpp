// SPDX-License-Identifier: Apache-2.0
#include "read/nastran/plain_elements.hpp"

#include "read/nastran/plain_cards.hpp"
#include "read/nastran/plain_lines.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace feelem::nastran {
namespace {

constexpr std::size_t kFieldsALine = 8;

/// Cards whose fields are number, property, nodes: nearly all.
bool is_usual(const ElementCard& card) {
    return card.property == 2 && card.first_node == 3;
}

/// Behind the mark at the end of a free line of eight fields and the one at the start of the next: at the
/// latter's comma. Null: neither a plain mark nor none.
const char* behind_marks(const char* comma) {
    const char* p = comma;
    if (*p == ',') ++p;
    if (*p == '+') ++p;
    if (*p == '\r') ++p;
    if (*p++ != '\n') return nullptr;
    if (*p == '+') ++p;
    return *p == ',' ? p : nullptr;
}

}  // namespace

std::optional<std::size_t> PlainElements::read(std::size_t at, PlainElement& element) {
    if (!like_.empty()) {
        if (const auto next = read_like(at, element)) return next;
    }
    if (!find_card(at)) return {};
    element.card = card_;
    if (text_[at + card_->name.size()] == ',') {
        if (const auto next = read_free(at, element)) return next;
    }
    return read_any(at, element);
}

/// The card of the name at `at`. Decks list the same card many times in a row.
bool PlainElements::find_card(std::size_t at) {
    if (card_ != nullptr && text_.substr(at, card_->name.size()) == card_->name) {
        const char behind = text_[std::min(at + card_->name.size(), text_.size() - 1)];
        if (behind == ',' || behind == ' ' || behind == '*') return true;
    }
    const std::size_t length = text_.substr(at, 9).find_first_of(" ,*\t\r\n");
    if (length == std::string_view::npos) return false;
    card_ = find_element_card(text_.substr(at, length));
    if (card_ != nullptr && card_->name == "PLOTEL") card_ = nullptr;
    return card_ != nullptr;
}

/// All fields found, as whole numbers; the first is an element's.
bool PlainElements::read_numbers(std::size_t count) {
    return whole_numbers_between(std::span(fields_).first(count), numbers_of_.data()) && numbers_of_[0] != 0;
}

/// Number, property and nodes as they were read together.
void PlainElements::put(std::size_t count, bool has_property, PlainElement& element) const {
    const std::size_t first = has_property ? 2 : 1;
    element.id = numbers_of_[0];
    element.property = has_property ? numbers_of_[1] : kBlankField;
    element.count = count - first;
    std::copy_n(
        numbers_of_.begin() + static_cast<std::ptrdiff_t>(first), element.count, element.nodes.begin()
    );
}

/// Fields up to the end of the card, as many as it may have; `first` is behind the comma of its name. Where
/// the next card starts, null when the card is not plain.
const char* PlainElements::find_free_fields(const char* first, std::size_t& count) {
    const std::size_t most = 2 + card_->node_count();
    for (count = 0; count < most;) {
        const char* const end = ends_.next();
        if (end == nullptr) return nullptr;
        fields_[count++] = {first, *end == '\n' && end[-1] == '\r' ? end - 1 : end};
        const bool is_full = count % kFieldsALine == 0;
        if (*end == '\n' && starts_card(end[1])) return end + 1;
        if (!is_full) {
            if (*end != ',') return nullptr;
            first = end + 1;
            continue;
        }
        const char* const comma = behind_marks(end);
        if (comma == nullptr) return nullptr;
        for (const char* p = end; p != comma; p = ends_.next()) {
            if (p == nullptr) return nullptr;
        }
        first = comma + 1;
    }
    return nullptr;
}

std::optional<std::size_t> PlainElements::read_free(std::size_t at, PlainElement& element) {
    const char* const card = text_.data() + at;
    if (!is_usual(*card_) || static_cast<std::ptrdiff_t>(at) < kFieldReach) return {};
    if (ends_at_ != at) ends_ = FieldEnds(card, text_.data() + text_.size());
    ends_at_ = std::string_view::npos;
    std::size_t count = 0;
    const char* const name_end = ends_.next();
    if (name_end == nullptr) return {};
    const char* const next = find_free_fields(name_end + 1, count);
    if (next == nullptr || count < 3 || !read_numbers(count)) return {};
    put(count, true, element);
    ends_at_ = static_cast<std::size_t>(next - text_.data());
    return ends_at_;
}

std::optional<std::size_t> PlainElements::read_like(std::size_t at, PlainElement& element) {
    if (text_.size() - at < like_.size() + kRoomBehind) return {};
    const char* const card = text_.data() + at;
    for (const Stretch& same : std::span(same_).first(same_count_)) {
        const auto length = static_cast<std::size_t>(same.last - same.first);
        if (!same_characters(card + same.first, like_.data() + same.first, length)) return {};
    }
    if (!starts_card(card[like_.size()])) return {};
    for (std::size_t i = 0; i < like_count_; ++i)
        fields_[i] = {card + numbers_[i].first, card + numbers_[i].last};
    if (!read_numbers(like_count_)) return {};
    element.card = like_card_;
    put(like_count_, like_has_property_, element);
    return at + like_.size();
}

/// Field by field.
std::optional<std::size_t> PlainElements::read_any(std::size_t at, PlainElement& element) {
    const ElementCard& card = *card_;
    const std::size_t length = card.name.size();
    const auto head = look_over_plain_card(text_, at, length);
    if (!head || head->id <= 0) return {};
    const std::size_t first = card.first_node - std::size_t{1};
    PlainFields fields;
    if (!read_plain_fields(text_, at, length, first + card.node_count(), fields)) return {};
    element.id = head->id;
    element.property = card.property == 0 ? kBlankField : fields.values[card.property - std::size_t{1}];
    element.count = 0;
    for (std::size_t i = 0; i < card.node_count(); ++i) {
        const std::int64_t node = fields.values[first + i];
        if (node > std::numeric_limits<std::int32_t>::max()) return {};
        element.nodes[i] = node == kBlankField ? 0 : static_cast<std::uint32_t>(node);
        if (element.nodes[i] != 0) element.count = i + 1;
    }
    if (text_[at + length] != ',') remember(text_.substr(at, head->next - at), element);
    return head->next;
}

/// Where the numbers of a fixed card stand: the next is like it when the same characters stand between its
/// own. Only a card whose fields up to the last node are filled, all but the property perhaps.
void PlainElements::remember(std::string_view card, const PlainElement& element) {
    constexpr std::size_t kLongest = 600;
    like_ = {};
    if (!is_usual(*card_) || card.size() > kLongest || element.count < 2) return;
    const std::size_t width = card[card_->name.size()] == '*' ? 16 : 8;
    const std::size_t wanted = 2 + element.count;
    like_count_ = same_count_ = 0;
    like_has_property_ = element.property != kBlankField;
    std::size_t same_from = 0;
    std::size_t field = 0;
    for (std::size_t line = 0; line < card.size() && field < wanted;) {
        const std::size_t end = std::min(card.find('\n', line), card.size());
        for (std::size_t at = line + kSmallColumn; at < line + kMarkColumn && field < wanted;
             at += width, ++field) {
            if (at >= end) return;
            if (field == 1 && !like_has_property_) continue;
            std::size_t last = std::min(at + width, end);
            while (last > at && (card[last - 1] < '0' || card[last - 1] > '9')) --last;
            const std::size_t first = last - at > kMostFieldDigits ? last - kMostFieldDigits : at;
            if (last == at || card.substr(at, first - at).find_first_not_of(' ') != std::string_view::npos)
                return;
            if (first > same_from)
                same_[same_count_++] = {
                    static_cast<std::uint16_t>(same_from), static_cast<std::uint16_t>(first)};
            numbers_[like_count_++] = {static_cast<std::uint16_t>(first), static_cast<std::uint16_t>(last)};
            same_from = last;
        }
        line = end + 1;
    }
    if (field < wanted) return;
    same_[same_count_++] = {static_cast<std::uint16_t>(same_from), static_cast<std::uint16_t>(card.size())};
    like_ = card;
    like_card_ = card_;
}

}  // namespace feelem::nastran
