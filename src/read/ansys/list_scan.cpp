// SPDX-License-Identifier: Apache-2.0
// Must: find every list in a file that may hold several, with page heads, footers, banners, prompts and
// notes in between, or no head at all, and never take such a line for a row.
// Assumes: a row begins with an unsigned number; heads begin with a letter or a star.
// Algorithm: one pass over the lines; rows only extend the current run; other lines are recognised by their
// first words and move a small state machine. Data: one run of bytes a page.
#include "read/ansys/list_scan.hpp"

#include "read/ansys/list_columns.hpp"
#include "read/ansys/list_element_lines.hpp"
#include "read/ansys/list_heads.hpp"
#include "read/ansys/list_taken.hpp"
#include "read/ansys/list_text.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

namespace feelem::ansys {
namespace {

constexpr std::size_t kMostLists = 200'000;

class Scanner {
public:
    Scanner(const Input& input, Diagnostics& diagnostics)
        : diagnostics_(diagnostics), file_{input, '\n', {}, {}} {
        file_.line_end = line_end_of(input.text());
    }

    ListFile run() {
        const std::string_view text = file_.input.text();
        Lines lines(text, 0, text.size(), file_.line_end);
        ReleaseBehind release(file_.input);
        while (lines.next()) {
            release.at(lines.begin());
            if (rows_ == Rows::Accepted && take_rows(lines)) continue;
            const char mark = first_mark(lines.line());
            if (mark == '\0') continue;
            if (is_digit(mark))
                number_line(lines);
            else if (mark != '-' && mark != '+' && mark != '.')
                text_line(lines);
        }
        // The last element may have been cut: that is seen when it is read.
        if (!file_.lists.empty() && ends_with_taken(file_.lists.back(), ListKind::Elements) &&
            file_.lists.back().runs.back().end == text.size())
            taker_.give_back(file_.lists.back());
        return std::move(file_);
    }

private:
    static bool ends_with_taken(const List& list, ListKind kind) {
        return list.kind == kind && !list.runs.empty() && list.runs.back().taken > 0;
    }

    /// Whether rows that are like others begin here: then all of them are read.
    bool take_rows(Lines& lines) {
        if (!is_digit(first_mark(lines.line()))) return false;
        const std::size_t end = taker_.take(file_.lists.back(), lines.begin(), new_run_);
        if (end == lines.begin()) return false;
        new_run_ = false;
        lines.go_to(end);
        return true;
    }

    /// What a line that begins with a number is taken for.
    enum class Rows {
        Accepted,  ///< A row of the current list.
        Guessed,   ///< Perhaps the first row of a list without column names.
        Ignored,   ///< Footer, banner, or a list that is not read.
    };

    void number_line(const Lines& lines) {
        if (rows_ == Rows::Ignored) return;
        // A lone 1 in the first column is the page feed of batch output.
        if (lines.line().front() == '1' && trim(lines.line()) == "1") {
            rows_ = Rows::Ignored;
            return;
        }
        if (rows_ == Rows::Guessed && !open_guessed(lines.line())) return;
        extend(lines);
        ++file_.lists.back().rows;
    }

    /// Adds a line to the current run, or begins the next one.
    void extend(const Lines& lines) {
        List& list = file_.lists.back();
        // A further line of the element before: it is none like the others.
        if (ends_with_taken(list, ListKind::Elements) && indent_of(lines.line()) >= kContinuationIndent)
            taker_.give_back(list);
        if (new_run_ || list.runs.empty() || list.runs.back().taken > 0)
            list.runs.push_back({lines.begin(), lines.end(), 0, 0, 0, 0});
        list.runs.back().end = lines.end();
        new_run_ = false;
    }

    void open(List list) {
        if (file_.lists.size() >= kMostLists) {
            throw Error(
                Code::TooLarge,
                file_.input.name(),
                fmt::format("more than {} lists in one file: is it a text list of Ansys?", kMostLists)
            );
        }
        file_.lists.push_back(std::move(list));
        taker_.begin(file_.lists.back());
        next_page_ = {};
    }

    bool open_guessed(std::string_view line) {
        const RowGuess guess = guess_row(line);
        if (guess.numbers == 0) return false;
        List list;
        list.display_system = display_system_;
        list.has_angles = guess.numbers == 6;
        if (title_ == Title::Values) {
            list.kind = ListKind::NodalValues;
            list.head = head_;
            list.head.columns = default_columns(head_.label, guess.numbers);
        } else if (guess.whole && guess.numbers >= 6) {
            list.kind = ListKind::Elements;
        } else if (guess.numbers == 3 || (guess.numbers == 6 && guess.angles)) {
            list.kind = ListKind::Nodes;
        } else {
            list.kind = ListKind::NodalValues;
            list.head.columns = default_columns("", guess.numbers);
        }
        open(std::move(list));
        rows_ = Rows::Accepted;
        new_run_ = true;
        return true;
    }

    void text_line(const Lines& lines) {
        if (!next_page_.empty() && lines.line() == next_page_) {
            begin_page();
            return;
        }
        next_page_ = {};
        const std::string line = capitals_of(lines.line());
        if (line.starts_with('*')) {
            star_line(line);
        } else if (line.starts_with("PRINT ")) {
            print_title(line);
        } else if (line.starts_with("LIST ")) {
            list_title(line, lines.begin());
        } else if (line.starts_with("NODE")) {
            node_columns(line, lines);
        } else if (line.starts_with("EL")) {
            element_line(line, lines);
        } else if (line.starts_with("KEYOPT(")) {
            keyopt_line(line);
        } else if (line.starts_with("DO NOT LIST NODES")) {
            lists_nodes_ = false;
        } else if (line.starts_with("MINIMUM ") || line.starts_with("MAXIMUM ") || line.starts_with("TOTAL ")) {
            rows_ = Rows::Ignored;
            continues_ = false;
        } else {
            head_line(line, lines);
        }
    }

    /// "***** POST1 NODAL STRESS LISTING *****" begins a page; other lines with stars are banners and notes.
    void star_line(std::string_view line) {
        rows_ = Rows::Ignored;
        const std::size_t post = line.find("POST1 ");
        const std::size_t listing = line.find(" LISTING");
        if (post == std::string_view::npos || listing == std::string_view::npos || listing < post) return;
        const std::string label = title_ == Title::Values ? head_.label : std::string();
        head_ = {};
        head_.label = label;
        head_.title = trim(line.substr(post + 6, std::max(listing, post + 6) - post - 6));
        title_ = Title::Values;
    }

    /// "PRINT S    NODAL SOLUTION PER NODE"
    void print_title(std::string_view line) {
        Cursor cursor(line.substr(5));
        head_ = {};
        if (!contains(line, "ELEMENT TABLE")) head_.label = next_word(cursor);
        title_ = Title::Values;
        continues_ = false;
        rows_ = contains(line, "PER ELEMENT") ? Rows::Ignored : Rows::Guessed;
    }

    void list_title(std::string_view line, std::size_t offset) {
        rows_ = Rows::Ignored;
        continues_ = false;
        title_ = Title::None;
        display_system_ = 0;
        lists_nodes_ = true;
        const bool elements =
            line.starts_with("LIST ALL SELECTED ELEMENTS") || line.starts_with("LIST ELEMENTS");
        if (elements || line.starts_with("LIST ALL SELECTED NODES") || line.starts_with("LIST NODES")) {
            display_system_ = whole_after(line, "DSYS=", 0);
            if (!elements) rows_ = Rows::Guessed;
            return;
        }
        if (line.starts_with("LIST ELEMENT TYPES")) return;
        Cursor cursor(line);
        std::string words;
        for (std::string_view word = next_word(cursor); !word.empty(); word = next_word(cursor)) {
            if (is_digit(word.front())) break;
            words += (words.empty() ? "" : " ") + std::string(word);
        }
        diagnostics_.add(
            Code::UnknownBlock,
            [&] { return file_.input.where_line(offset); },
            fmt::format("the list \"{}\" is not used", words)
        );
    }

    /// "NODE  X  Y  Z" heads nodes, "NODE  UX  UY" values, "NODE  7  12" is the footer's.
    void node_columns(std::string_view line, const Lines& lines) {
        const bool of_element =
            !file_.lists.empty() && file_.lists.back().kind == ListKind::ElementNodalValues;
        if (of_element && rows_ == Rows::Accepted) return;  // Stays between the rows.
        List list;
        Cursor cursor(line);
        if (next_word(cursor) != "NODE") return;
        list.head = head_;
        if (!read_columns(line, cursor, list.head)) return;
        const std::vector<std::string>& columns = list.head.columns;
        if (columns.size() >= 3 && columns[0] == "X" && columns[1] == "Y" && columns[2] == "Z") {
            list.kind = ListKind::Nodes;
            list.has_angles = columns.size() >= 6;
            list.display_system = display_system_;
            list.head = {};
        } else if (contains(head_.title, "ELEMENT NODAL")) {
            return;  // Values of no element: its line is missing.
        } else {
            list.kind = ListKind::NodalValues;
        }
        if (continue_or_open(std::move(list))) next_page_ = lines.line();
    }

    /// "ELEM MAT TYP", "ELEM SEQV", "ELEMENT TYPE 1 IS", "ELEMENT= 1 SOLID187".
    void element_line(std::string_view line, const Lines& lines) {
        Cursor cursor(line);
        const std::string_view first = next_word(cursor);
        if (first.starts_with("ELEMENT=")) {
            element_of_values(lines);
            return;
        }
        if (first == "ELEMENT" && line.substr(7).find_first_not_of(' ') != std::string_view::npos) {
            if (next_word(cursor) == "TYPE") type_line(cursor);
            return;
        }
        if (first != "ELEM" && first != "EL") return;
        List list;
        list.head = head_;
        if (!read_columns(line, cursor, list.head)) return;
        const std::vector<std::string>& columns = list.head.columns;
        if (columns.front() == "MAT") {
            list.kind = ListKind::Elements;
            list.has_nodes = lists_nodes_ && columns.back() == "NODES";
            list.head = {};
        } else {
            list.kind = ListKind::ElementValues;
        }
        if (continue_or_open(std::move(list))) next_page_ = lines.line();
    }

    /// Column names behind the first word. False when numbers stand there: a footer.
    static bool read_columns(std::string_view line, Cursor cursor, ValueHead& head) {
        head.columns.clear();
        std::size_t previous = 0;
        for (std::string_view word = next_word(cursor); !word.empty(); word = next_word(cursor)) {
            if (is_digit(word.front()) || word.front() == '-') return false;
            const auto at = static_cast<std::size_t>(word.data() - line.data());
            if (!head.columns.empty()) head.column_width = at - previous;
            previous = at;
            head.columns.emplace_back(word);
        }
        return !head.columns.empty();
    }

    /// Rows of the list follow that was there before.
    void begin_page() {
        rows_ = Rows::Accepted;
        new_run_ = true;
    }

    /// Whether the list before goes on.
    bool continue_or_open(List list) {
        begin_page();
        if (continues_ && !file_.lists.empty()) {
            const List& last = file_.lists.back();
            const bool same = last.kind == list.kind && last.display_system == list.display_system &&
                              last.has_angles == list.has_angles && last.has_nodes == list.has_nodes;
            // The table of each element has its own columns line; their widths may differ by a blank.
            if (same && last.head == list.head) return true;
        }
        continues_ = true;
        open(std::move(list));
        return false;
    }

    /// The rows of PRESOL keep these lines between them: the element stands nowhere else.
    void element_of_values(const Lines& lines) {
        if (title_ != Title::Values) return;
        const bool goes_on =
            continues_ && !file_.lists.empty() && file_.lists.back().kind == ListKind::ElementNodalValues;
        List list;
        list.kind = ListKind::ElementNodalValues;
        list.head = head_;
        if (goes_on) {
            list.head.columns = file_.lists.back().head.columns;
            list.head.column_width = file_.lists.back().head.column_width;
        } else {
            list.head.columns = columns_below(lines, list.head.column_width);
            if (list.head.columns.empty()) return;
        }
        const bool in_run = goes_on && rows_ == Rows::Accepted && !new_run_;
        continue_or_open(std::move(list));
        new_run_ = !in_run;
        extend(lines);
    }

    /// The columns line under the first ELEMENT= line.
    std::vector<std::string> columns_below(const Lines& lines, std::size_t& width) const {
        const std::string_view text = file_.input.text();
        Lines below(text, lines.end(), text.size(), file_.line_end);
        for (int i = 0; i < 3 && below.next(); ++i) {
            const std::string line = capitals_of(below.line());
            Cursor cursor{std::string_view(line)};
            ValueHead head;
            if (next_word(cursor) != "NODE" || !read_columns(line, cursor, head)) continue;
            width = head.column_width;
            return head.columns;
        }
        return {};
    }

    void type_line(Cursor cursor) {
        std::int64_t number = 0;
        if (!scan_unsigned(cursor, number) || number > std::numeric_limits<std::int32_t>::max()) return;
        if (next_word(cursor) != "IS") return;
        std::string_view name = next_word(cursor);
        while (name.ends_with('.')) name.remove_suffix(1);
        if (name.empty()) return;
        type_ = static_cast<int>(number);
        file_.types[type_].name = name;
    }

    /// "KEYOPT( 1- 6)=  0  0": only the first is used.
    void keyopt_line(std::string_view line) {
        if (type_ == 0 || whole_after(line, "KEYOPT(", 0) != 1) return;
        file_.types[type_].keyopt1 = whole_after(line, ")=", 0);
    }

    /// Steps and notes between a page's title and its columns.
    void head_line(std::string_view line, const Lines& lines) {
        if (line.starts_with("LOAD STEP=")) {
            head_.has_step = true;
            head_.step = whole_after(line, "LOAD STEP=", 1);
            head_.substep = whole_after(line, "SUBSTEP=", 1);
        } else if (line.starts_with("TIME=") || line.starts_with("FREQ=")) {
            head_.is_frequency = line.starts_with("FREQ");
            head_.value = number_after(line, "=").value_or(0);
            head_.load_case = whole_after(line, "LOAD CASE=", 0);
        } else if (line.starts_with("THE FOLLOWING ")) {
            axes_note(line);
        } else if (contains(line, "RESULTS ARE") && contains(line, "FOR MATERIAL")) {
            head_.material = whole_after(line, "FOR MATERIAL", 0);
            head_.has_layers = contains(line, "TOP/BOTTOM");
        } else if (rows_ == Rows::Accepted && !new_run_ && !line.starts_with("MORE (YES,NO")) {
            diagnostics_.add(
                Code::UnknownBlock,
                [&] { return file_.input.where_line(lines.begin()); },
                "lines among the rows of a list are neither rows nor heads; they are left out"
            );
        }
    }

    void axes_note(std::string_view line) {
        if (contains(line, "GLOBAL")) {
            head_.axes = AxesNote::Global;
        } else if (contains(line, "NODAL COORDINATE SYSTEM")) {
            head_.axes = AxesNote::Nodal;
        } else if (contains(line, "COORDINATE") && whole_after(line, "COORDINATE SYSTEM", 1) == 0) {
            head_.axes = AxesNote::Global;
        } else if (contains(line, "COORDINATE")) {
            head_.axes = AxesNote::Other;
            head_.axes_text = line;
        }
    }

    enum class Title {
        None,
        Values,  ///< PRINT ... or ***** POST1 ... came before.
    };

    Diagnostics& diagnostics_;
    ListFile file_;
    RowTaker taker_{file_};
    Rows rows_ = Rows::Guessed;
    Title title_ = Title::None;
    bool continues_ = false;  ///< An equal head goes on with the last list: no title or footer in between.
    bool new_run_ = true;
    /// The columns that went on with the last list, while nothing but rows came after them: they will again.
    std::string_view next_page_;
    ValueHead head_;
    int display_system_ = 0;
    bool lists_nodes_ = true;
    int type_ = 0;
};

}  // namespace

ListFile scan_lists(const Input& input, Diagnostics& diagnostics) {
    return Scanner(input, diagnostics).run();
}

}  // namespace feelem::ansys
