// SPDX-License-Identifier: Apache-2.0
// VTK's readers behind one face: times, and the data sets at a time.
#pragma once

#include <vtkSmartPointer.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

class vtkDataSet;

namespace feelem::exchange {

struct Merged;
struct NeutralModel;

/// A data set without blocks of its own, and what its block is called.
struct Leaf {
    std::string name;
    vtkSmartPointer<vtkDataSet> data;
};

class VtkReader {
public:
    virtual ~VtkReader() = default;
    /// Empty: one state without a time.
    virtual std::vector<double> times() = 0;
    virtual std::vector<Leaf> read(std::size_t step) = 0;
    /// Whether every step has the arrays of the first.
    virtual bool same_arrays() const { return true; }
    /// Whether the files are VTK's own, whose wedges have the triangle 0 1 2 facing away from 3 4 5. VTK's
    /// readers of other formats turn some wedges and others not: the sign of the volume tells.
    virtual bool own_format() const { return true; }
    /// Sets of nodes that the data sets do not show. `merged` is what made `model` of them.
    virtual void add_sets(const Merged&, NeutralModel&) const {}
};

/// `format`: vtk vtu pvd exodus ensight cgns d3plot. Throws std::runtime_error with VTK's words.
std::unique_ptr<VtkReader> open_vtk(const std::string& format, const std::string& path);

}  // namespace feelem::exchange
