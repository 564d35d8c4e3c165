// SPDX-License-Identifier: Apache-2.0
// What lists a file holds and where their rows stand: titles, page heads and column names, no values yet.
#pragma once

#include "base/input.hpp"

#include "feelem/diagnostics.hpp"
#include "feelem/mesh.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace feelem::ansys {

enum class ListKind {
    Nodes,               ///< NLIST
    Elements,            ///< ELIST
    NodalValues,         ///< PRNSOL, PRRSOL
    ElementNodalValues,  ///< PRESOL: a table of nodes for each element.
    ElementValues,       ///< PRETAB
};

/// The coordinate system that a note above the columns names.
enum class AxesNote {
    None,
    Global,
    Nodal,  ///< Each node's own.
    Other,  ///< RSYS, element or solution systems.
};

/// What stands above the columns of a page of values. Pages with equal heads are one list.
struct ValueHead {
    std::string label;  ///< Of the title PRINT U: "U"; empty without title.
    std::string title;  ///< Of ***** POST1 ... LISTING *****: "NODAL STRESS".
    bool has_step = false;
    int step = 1;
    int substep = 1;
    int load_case = 0;
    bool is_frequency = false;  ///< FREQ= instead of TIME=.
    double value = 0;           ///< Time or frequency.
    int material = 0;           ///< 0: the list is not by material.
    bool has_layers = false;    ///< Shells: a row for the top, then one for the bottom.
    AxesNote axes = AxesNote::None;
    std::string axes_text;  ///< The note when it is AxesNote::Other.
    std::vector<std::string> columns;
    std::size_t column_width = 0;  ///< 0: unknown.

    bool operator==(const ValueHead&) const = default;
};

struct TextRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// Rows that stand one after the other.
struct RowRun {
    std::size_t begin = 0;
    std::size_t end = 0;
    /// All its rows (nodes or elements), when they were read while they were found: equally long, the next
    /// ones in the list's TakenRows. 0: they are still to be read.
    std::size_t taken = 0;
    std::size_t nodes_each = 0;  ///< Of the elements taken, as the next two.
    std::int64_t material = 0;
    std::int64_t type = 0;
};

/// What rows hold that were read while they were found, so that their bytes are touched once.
struct TakenRows {
    std::vector<NodeId> node_ids;
    std::vector<Point3> places;
    std::vector<ElementId> element_ids;
    /// Their ids, in the memory that will hold their indices: see ElementAdder::take_over.
    std::vector<NodeIndex> element_nodes;
};

struct List {
    ListKind kind = ListKind::Nodes;
    std::vector<RowRun> runs;  ///< One a page or more; between them only heads.
    TakenRows taken;
    std::size_t in_mesh = 0;  ///< So many of the first runs became elements of the mesh already.
    std::size_t rows = 0;     ///< Lines that begin with a number: a bound, some may be other text.
    ValueHead head;           ///< Of values.
    int display_system = 0;   ///< DSYS of nodes.
    bool has_angles = false;  ///< Of nodes.
    bool has_nodes = true;    ///< Of elements: false after DO NOT LIST NODES.
};

struct ListedType {
    std::string name;  ///< "SOLID185"
    int keyopt1 = 0;
};

/// One file of lists.
struct ListFile {
    Input input;
    char line_end = '\n';
    std::vector<List> lists;
    std::map<int, ListedType> types;  ///< ETLIST.
};

/// Finds the lists of a file. Lists of other kinds are counted (UnknownBlock).
ListFile scan_lists(const Input& input, Diagnostics& diagnostics);

}  // namespace feelem::ansys
