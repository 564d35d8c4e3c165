// SPDX-License-Identifier: Apache-2.0
// Small .frd files made in tests.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace feelem::test {

/// One tetrahedron with nodes 1 to 4 as text, and result blocks as given.
class FrdText {
public:
    FrdText& node(std::int64_t id, double x, double y, double z);
    /// A block's head: "-5" lines are NAME,kind,first index,second index,exists.
    FrdText& result(
        const std::string& name,
        const std::vector<std::string>& components,
        std::size_t count,
        int step = 1,
        double value = 1,
        int analysis = 0
    );
    /// Any line of a body.
    FrdText& line(const std::string& text);
    /// A record of up to six values in E12.5.
    FrdText& record(std::int64_t id, const std::vector<double>& values);
    FrdText& end_block() { return line(" -3"); }
    std::string text() const;

private:
    std::string nodes_;
    std::size_t node_count_ = 0;
    std::string results_;
};

/// A "-5" line's description for FrdText::result.
std::string scalar(const std::string& name);
std::vector<std::string> vector_with_all(const std::string& letter);  ///< D1 D2 D3 and the unstored ALL

/// One tetrahedron and its temperatures 10 20 30 40 in binary (format digit 2), either byte order.
std::string binary_frd(bool swapped);

}  // namespace feelem::test
