// SPDX-License-Identifier: Apache-2.0
// The peer of whole conversions: VTK reads the block of bench_make_cdb from a .vtu, takes its skin and writes
// glTF.
//   make SIDE OUT.vtu raw|ascii   the same nodes and elements, to the digits of the archive
//   gltf IN.vtu OUT.gltf          vtkXMLUnstructuredGridReader, vtkDataSetSurfaceFilter, vtkGLTFWriter
//   read IN.vtu                   the reader alone
//   skin IN.vtu                   number, area and nodes of the facets, as JSON: to compare answers, not to
//   be timed
#include "../block.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkGLTFWriter.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersion.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using bench::Block;

/// The double that thirteen decimals say.
double printed(double value) {
    return std::strtod(fmt::format("{:.13E}", value).c_str(), nullptr);
}

void make(int side, const char* path, bool ascii) {
    const Block block{side};
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(block.node_count());
    block.for_each_node([&](int id, const auto& p) {
        points->SetPoint(id - 1, printed(p[0]), printed(p[1]), printed(p[2]));
    });
    vtkNew<vtkUnstructuredGrid> grid;
    grid->SetPoints(points);
    grid->Allocate(block.element_count());
    block.for_each_element([&](int, const std::array<int, 8>& nodes) {
        std::array<vtkIdType, 8> ids{};
        for (std::size_t i = 0; i < 8; ++i) ids[i] = nodes[i] - 1;
        grid->InsertNextCell(VTK_HEXAHEDRON, 8, ids.data());
    });
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetFileName(path);
    writer->SetInputData(grid);
    writer->SetCompressorTypeToNone();
    if (ascii) {
        writer->SetDataModeToAscii();
    } else {
        writer->SetDataModeToAppended();
        writer->EncodeAppendedDataOff();
    }
    if (writer->Write() != 1) throw std::runtime_error("cannot write the .vtu");
}

void open(vtkXMLUnstructuredGridReader* reader, const char* path) {
    if (reader->CanReadFile(path) != 1) throw std::runtime_error("cannot read the .vtu");
    reader->SetFileName(path);
}

void convert(const char* from, const char* to) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    open(reader, from);
    vtkNew<vtkDataSetSurfaceFilter> filter;
    filter->SetInputConnection(reader->GetOutputPort());
    filter->Update();
    // The writer takes buildings that are made of parts.
    vtkNew<vtkMultiBlockDataSet> building, all;
    building->SetBlock(0, filter->GetOutput());
    all->SetBlock(0, building);
    vtkNew<vtkGLTFWriter> writer;
    writer->SetFileName(to);
    writer->SetInputDataObject(all);
    writer->Write();
}

/// Of a quad the four triangles round its centre, as scenes are cut.
double quad_area(vtkPolyData* skin, vtkIdList* corners) {
    using Place = std::array<double, 3>;
    std::vector<Place> at(static_cast<std::size_t>(corners->GetNumberOfIds()));
    Place centre{};
    for (std::size_t i = 0; i < at.size(); ++i) {
        skin->GetPoint(corners->GetId(static_cast<vtkIdType>(i)), at[i].data());
        for (std::size_t axis = 0; axis < 3; ++axis)
            centre[axis] += at[i][axis] / static_cast<double>(at.size());
    }
    double area = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const Place& p = at[i];
        const Place& q = at[(i + 1) % at.size()];
        const Place a{p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]};
        const Place b{q[0] - centre[0], q[1] - centre[1], q[2] - centre[2]};
        area +=
            0.5 * std::hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]);
    }
    return area;
}

void tell_skin(const char* path) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    open(reader, path);
    vtkNew<vtkDataSetSurfaceFilter> filter;
    filter->SetInputConnection(reader->GetOutputPort());
    filter->PassThroughPointIdsOn();
    filter->Update();
    vtkPolyData* skin = filter->GetOutput();
    auto* ids = vtkIdTypeArray::SafeDownCast(skin->GetPointData()->GetArray("vtkOriginalPointIds"));
    if (ids == nullptr) throw std::runtime_error("VTK names no points");
    vtkIdType sum = 0;
    for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i) sum += ids->GetValue(i) + 1;
    double area = 0;
    vtkNew<vtkIdList> corners;
    for (vtkIdType cell = 0; cell < skin->GetNumberOfCells(); ++cell) {
        skin->GetCellPoints(cell, corners);
        area += quad_area(skin, corners);
    }
    fmt::print(
        "{{\"facets\": {}, \"nodes\": {}, \"sum_of_node_ids\": {}, \"area\": {:.12g}}}\n",
        skin->GetNumberOfCells(),
        skin->GetNumberOfPoints(),
        sum,
        area
    );
}

/// In the words of bench_read_model.
void read(const char* path) {
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    open(reader, path);
    const std::clock_t start = std::clock();
    reader->Update();
    const double cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    vtkUnstructuredGrid* grid = reader->GetOutput();
    std::array<double, 3> sum{};
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += grid->GetPoint(i)[axis];
    }
    vtkNew<vtkIdList> corners;
    vtkIdType corner_sum = 0;
    for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell) {
        grid->GetCellPoints(cell, corners);
        for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i) corner_sum += corners->GetId(i) + 1;
    }
    fmt::print(
        "{{\"open_cpu\": {:.5f}, \"load_cpu\": 0, \"nodes\": {}, \"elements\": {}, \"corners\": {}, \"x\": "
        "{:.17g}, "
        "\"y\": {:.17g}, \"z\": {:.17g}, \"version\": \"{}\"}}\n",
        cpu,
        grid->GetNumberOfPoints(),
        grid->GetNumberOfCells(),
        corner_sum,
        sum[0],
        sum[1],
        sum[2],
        vtkVersion::GetVTKVersion()
    );
}

}  // namespace

int main(int argc, char** argv) {
    const std::string verb = argc > 1 ? argv[1] : "";
    try {
        if (verb == "make" && argc == 5)
            make(std::atoi(argv[2]), argv[3], std::string(argv[4]) == "ascii");
        else if (verb == "gltf" && argc == 4)
            convert(argv[2], argv[3]);
        else if (verb == "read" && argc == 3)
            read(argv[2]);
        else if (verb == "skin" && argc == 3)
            tell_skin(argv[2]);
        else
            throw std::runtime_error("usage: make SIDE OUT.vtu raw|ascii, gltf IN OUT, read IN, skin IN");
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_vtk_block: {}\n", error.what());
        return 1;
    }
}
