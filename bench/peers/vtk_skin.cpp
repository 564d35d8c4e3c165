// SPDX-License-Identifier: Apache-2.0
// The peer of bench_skin: VTK takes the skin of the same mesh. Input: an unstructured grid with float points,
// 64-bit ids and one float result, as VTK's own readers make it. `dss`: vtkDataSetSurfaceFilter; `geometry`:
// vtkGeometryFilter, exact; `chain`: what comes nearest to our whole stage, vtkDataSetSurfaceFilter,
// triangles, and normals with vertices split at 30 degrees. It has no edges, though our stage has:
// vtkFeatureEdges of VTK 9.1 asks for points * points / 200 * 8 bytes and fails on large skins.
#include "../skin_mesh.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkFloatArray.h>
#include <vtkGeometryFilter.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkTriangleFilter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

/// VTK's wedge winds its triangles the other way.
std::array<vtkIdType, 27> cell_nodes(
    const feelem::ElementBlock& block, std::size_t first, std::size_t width
) {
    std::array<vtkIdType, 27> nodes{};
    for (std::size_t i = 0; i < width; ++i) nodes[i] = feelem::raw(block.nodes[first + i]);
    if (block.type == feelem::ElementType::Wedge6) {
        std::swap(nodes[1], nodes[2]);
        std::swap(nodes[4], nodes[5]);
    }
    return nodes;
}

void fill(vtkUnstructuredGrid* grid, const feelem::Mesh& mesh) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.node_count()));
    vtkNew<vtkFloatArray> values;
    values->SetName("temperature");
    values->SetNumberOfValues(static_cast<vtkIdType>(mesh.node_count()));
    for (std::size_t i = 0; i < mesh.node_count(); ++i) {
        points->SetPoint(static_cast<vtkIdType>(i), mesh.coordinates[i].data());
        values->SetValue(static_cast<vtkIdType>(i), bench::value_at(static_cast<std::uint32_t>(i)));
    }
    grid->SetPoints(points);
    grid->GetPointData()->AddArray(values);
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> types;
    vtkIdType entries = 0;
    for (const feelem::ElementBlock& block : mesh.blocks)
        entries += static_cast<vtkIdType>(block.nodes.size());
    cells->AllocateExact(static_cast<vtkIdType>(mesh.element_count()), entries);
    types->Allocate(static_cast<vtkIdType>(mesh.element_count()));
    for (const feelem::ElementBlock& block : mesh.blocks) {
        const feelem::ElementRow& row = feelem::element_row(block.type);
        for (std::size_t first = 0; first < block.nodes.size(); first += row.node_count) {
            const auto nodes = cell_nodes(block, first, row.node_count);
            cells->InsertNextCell(row.node_count, nodes.data());
            types->InsertNextValue(row.vtk_type);
        }
    }
    grid->SetCells(types, cells);
}

/// Numbers of our own: the ids that VTK passes through are those of a grid in between where elements are
/// quadratic.
void add_node_numbers(vtkUnstructuredGrid* grid) {
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("node");
    ids->SetNumberOfValues(grid->GetNumberOfPoints());
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) ids->SetValue(i, i);
    grid->GetPointData()->AddArray(ids);
}

struct Found {
    bench::FacetSum facets;
    double value_sum = 0, area = 0, volume = 0;
};

Found look_at(vtkPolyData* skin, const std::string& node_ids) {
    Found found;
    auto* values = vtkFloatArray::SafeDownCast(skin->GetPointData()->GetArray("temperature"));
    for (vtkIdType i = 0; i < skin->GetNumberOfPoints(); ++i)
        found.value_sum += static_cast<double>(values->GetValue(i));
    auto* ids = node_ids.empty()
                    ? nullptr
                    : vtkIdTypeArray::SafeDownCast(skin->GetPointData()->GetArray(node_ids.c_str()));
    vtkNew<vtkIdList> corners;
    std::vector<std::uint32_t> nodes;
    for (vtkIdType cell = 0; cell < skin->GetNumberOfCells(); ++cell) {
        skin->GetCellPoints(cell, corners);
        nodes.clear();
        std::array<double, 3> a{}, b{}, c{};
        skin->GetPoint(corners->GetId(0), a.data());
        for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i) {
            if (ids != nullptr) nodes.push_back(static_cast<std::uint32_t>(ids->GetValue(corners->GetId(i))));
            if (i < 2) continue;
            skin->GetPoint(corners->GetId(i - 1), b.data());
            skin->GetPoint(corners->GetId(i), c.data());
            const std::array n{
                (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]),
                (b[2] - a[2]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[2] - a[2]),
                (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])};
            found.area += 0.5 * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            found.volume += (n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) / 6;
        }
        // Where hexahedra repeat nodes, VTK keeps sides that are lines, and triangles as quads.
        std::ranges::sort(nodes);
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        if (nodes.size() >= 3) found.facets.add(nodes);
    }
    return found;
}

struct Run {
    vtkNew<vtkPolyData> skin;
    double cpu = 0, wall = 0;
    std::size_t extra = 0;
};

/// Times `work`, which gives the skin.
template <class Work>
void run(Run& run, Work work) {
    const std::size_t before = bench::resident_bytes();
    bench::forget_peak();
    const double cpu = bench::cpu_seconds();
    const auto start = std::chrono::steady_clock::now();
    run.skin->ShallowCopy(work());
    run.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    run.cpu = bench::cpu_seconds() - cpu;
    run.extra = bench::peak_bytes() - before;
}

template <class Filter>
vtkPolyData* output(Filter& filter) {
    filter->Update();
    return filter->GetOutput();
}

/// `level`: into how many pieces curved sides are cut (0: corners alone, as bench_skin sums facets).
void take_skin(const std::string& name, vtkUnstructuredGrid* grid, int level, Run& out) {
    vtkNew<vtkGeometryFilter> geometry;
    vtkNew<vtkDataSetSurfaceFilter> surface;
    vtkNew<vtkTriangleFilter> triangles;
    vtkNew<vtkPolyDataNormals> normals;
    geometry->SetInputData(grid);
    geometry->SetNonlinearSubdivisionLevel(level);
    surface->SetInputData(grid);
    surface->SetNonlinearSubdivisionLevel(level);
    triangles->SetInputConnection(surface->GetOutputPort());
    normals->SetInputConnection(triangles->GetOutputPort());
    normals->SetFeatureAngle(30);
    normals->SplittingOn();
    normals->ConsistencyOff();  // The filters before it wind all facets outward.
    run(out, [&] {
        if (name == "geometry") return output(geometry);
        if (name == "dss") return output(surface);
        return output(normals);
    });
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5 && argc != 6) {
        std::fputs("usage: bench_vtk_skin dss|geometry|chain KIND CELLS NUMBERING [prove]\n", stderr);
        return 2;
    }
    try {
        vtkNew<vtkUnstructuredGrid> grid;
        {
            const feelem::Mesh mesh = bench::make_mesh(argv[2], std::stoul(argv[3]), argv[4]);
            fill(grid, mesh);
        }
        Run timed, checked;
        take_skin(argv[1], grid, 1, timed);
        Found found, facets;
        if (argc == 6) {
            found = look_at(timed.skin, "");
            add_node_numbers(grid);
            take_skin("dss", grid, 0, checked);
            facets = look_at(checked.skin, "node");
        }
        fmt::print(
            "{{\"cells\": {}, \"nodes\": {}, \"cpu\": {:.6f}, \"wall\": {:.6f}, \"extra_bytes\": {}, "
            "\"facets\": {}, "
            "\"facet_sum\": {}, \"area\": {:.9g}, \"volume\": {:.9g}, \"value_sum\": {:.9g}}}\n",
            grid->GetNumberOfCells(),
            grid->GetNumberOfPoints(),
            timed.cpu,
            timed.wall,
            timed.extra,
            facets.facets.count,
            facets.facets.sum,
            found.area,
            found.volume,
            found.value_sum
        );
    } catch (const std::exception& error) {
        fmt::print(stderr, "bench_vtk_skin: {}\n", error.what());
        return 1;
    }
}
