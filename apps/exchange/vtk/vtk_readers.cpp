// SPDX-License-Identifier: Apache-2.0
#include "vtk/vtk_readers.hpp"

#include "base/input.hpp"
#include "read/exchange/family_names.hpp"
#include "vtk/ensight_check.hpp"
#include "vtk/exodus_sets.hpp"
#include "vtk/exodus_values.hpp"
#include "vtk/joined_tensors.hpp"
#include "vtk/netcdf_size.hpp"
#include "vtk/vtk_mesh.hpp"

#include <vtkAlgorithm.h>
#include <vtkCGNSReader.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkExodusIIReader.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkGenericEnSightReader.h>
#include <vtkInformation.h>
#include <vtkLSDynaReader.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkXMLGenericDataObjectReader.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

namespace feelem::exchange {
namespace {

/// Keeps what VTK says of errors. Warnings are silent, but those of bytes that could not be read: then VTK
/// goes on with what it has.
class Words : public vtkOutputWindow {
public:
    static Words* New();
    vtkTypeMacro(Words, vtkOutputWindow) void DisplayText(const char*) override {}
    void DisplayErrorText(const char* text) override {
        if (errors.size() < 2000) errors += text;
    }
    void DisplayWarningText(const char* text) override { keep_of_reading(text); }
    void DisplayGenericWarningText(const char* text) override { keep_of_reading(text); }
    void DisplayDebugText(const char*) override {}
    std::string errors;

private:
    void keep_of_reading(const std::string& text) {
        if (text.find("Error reading") != std::string::npos) DisplayErrorText(text.c_str());
    }
};
vtkStandardNewMacro(Words)

    /// The sentence of "ERROR: In file, line 1\nvtkX (0x1): sentence".
    std::string sentence_of(const std::string& text) {
    if (text.find("returned failure for request") != std::string::npos) return "it gives no reason";
    std::size_t at = text.find("): ");
    if (at != std::string::npos) return text.substr(at + 3, text.find('\n', at) - at - 3);
    at = text.find("Error reading");
    if (at == std::string::npos) at = 0;
    return text.substr(at, text.find('\n', at) - at);
}

vtkNew<Words>& words() {
    static vtkNew<Words> window;
    return window;
}

void throw_on_error() {
    if (!words()->errors.empty())
        throw std::runtime_error(
            "VTK cannot read the file; it may be damaged, or not copied whole: " +
            sentence_of(words()->errors)
        );
}

void add_leaves(vtkDataObject* object, const std::string& name, std::vector<Leaf>& leaves) {
    if (auto* const data = vtkDataSet::SafeDownCast(object)) {
        leaves.push_back({name, data});
        return;
    }
    auto* const composite = vtkCompositeDataSet::SafeDownCast(object);
    if (composite == nullptr) return;
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem()) {
        const char* own = nullptr;
        if (iterator->HasCurrentMetaData())
            own = iterator->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME());
        add_leaves(iterator->GetCurrentDataObject(), own != nullptr ? own : name, leaves);
    }
}

/// Any reader that follows VTK's pipeline.
class PipelineReader : public VtkReader {
public:
    PipelineReader(vtkSmartPointer<vtkAlgorithm> reader, bool own_format)
        : reader_(std::move(reader)), own_format_(own_format) {
        reader_->UpdateInformation();
        throw_on_error();
    }

    std::vector<double> times() override {
        vtkInformation* const info = reader_->GetOutputInformation(0);
        const auto key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
        if (info == nullptr || !info->Has(key)) return {};
        const double* const first = info->Get(key);
        return {first, first + info->Length(key)};
    }

    std::vector<Leaf> read(std::size_t step) override {
        const std::vector<double> all = times();
        if (step < all.size())
            reader_->UpdateTimeStep(all[step]);
        else
            reader_->Update();
        throw_on_error();
        std::vector<Leaf> leaves;
        add_leaves(reader_->GetOutputDataObject(0), "", leaves);
        return leaves;
    }

    bool own_format() const override { return own_format_; }

private:
    vtkSmartPointer<vtkAlgorithm> reader_;
    bool own_format_;
};

/// VTK gives legacy files the time 0, which nobody wrote.
class LegacyReader : public PipelineReader {
public:
    explicit LegacyReader(vtkSmartPointer<vtkAlgorithm> reader) : PipelineReader(std::move(reader), true) {}
    std::vector<double> times() override { return {}; }
};

std::unique_ptr<VtkReader> open_legacy(const std::string& path) {
    vtkNew<vtkGenericDataObjectReader> reader;
    reader->SetFileName(path.c_str());
    reader->ReadAllScalarsOn();
    reader->ReadAllVectorsOn();
    reader->ReadAllTensorsOn();
    reader->ReadAllFieldsOn();
    reader->ReadAllNormalsOn();
    return std::make_unique<LegacyReader>(reader.Get());
}

std::unique_ptr<VtkReader> open_xml(const std::string& path) {
    vtkNew<vtkXMLGenericDataObjectReader> reader;
    reader->SetFileName(path.c_str());
    return std::make_unique<PipelineReader>(reader.Get(), true);
}

/// Our own reader of ParaView's lists: VTK has none.
class PvdReader : public VtkReader {
public:
    explicit PvdReader(const std::string& path) {
        const std::filesystem::path folder = std::filesystem::path(path).parent_path();
        for (const PvdEntry& entry : read_pvd(Input::from_file(path).text(), path)) {
            if (times_.empty() || times_.back() != entry.time) {
                times_.push_back(entry.time);
                files_.emplace_back();
            }
            files_.back().push_back({(folder / entry.file).string(), entry.part});
        }
    }
    std::vector<double> times() override { return times_; }
    std::vector<Leaf> read(std::size_t step) override {
        std::vector<Leaf> leaves;
        for (const auto& [file, part] : files_.at(step)) {
            for (Leaf& leaf : open_xml(file)->read(0)) {
                if (leaf.name.empty()) leaf.name = part;
                leaves.push_back(std::move(leaf));
            }
        }
        return leaves;
    }
    bool same_arrays() const override { return false; }

private:
    std::vector<double> times_;
    std::vector<std::vector<std::pair<std::string, std::string>>> files_;  ///< And their parts' names.
};

/// Of files whose values the Exodus library does not find, they are put in after it.
class ExodusReader : public PipelineReader {
public:
    ExodusReader(vtkSmartPointer<vtkAlgorithm> reader, const std::string& path)
        : PipelineReader(std::move(reader), false), path_(path), values_(path) {}
    std::vector<Leaf> read(std::size_t step) override {
        std::vector<Leaf> leaves = PipelineReader::read(step);
        values_.put_into(leaves, step);
        join_tensors(leaves);
        return leaves;
    }
    void add_sets(const Merged& merged, NeutralModel& model) const override {
        if (merged.has_node_ids) add_exodus_sets(path_, merged.has_element_ids, model);
    }

private:
    std::string path_;
    ExodusValues values_;
};

std::unique_ptr<VtkReader> open_exodus(const std::string& path) {
    check_netcdf_size(path);
    vtkNew<vtkExodusIIReader> reader;
    reader->SetFileName(path.c_str());
    // By default points are moved by the displacements: they would count twice.
    reader->SetApplyDisplacements(0);
    reader->GenerateGlobalNodeIdArrayOn();
    reader->GenerateGlobalElementIdArrayOn();
    reader->UpdateInformation();
    throw_on_error();
    for (const int type : {vtkExodusIIReader::NODAL, vtkExodusIIReader::ELEM_BLOCK}) {
        for (int i = 0; i < reader->GetNumberOfObjectArrays(type); ++i)
            reader->SetObjectArrayStatus(type, reader->GetObjectArrayName(type, i), 1);
    }
    for (const int type :
         {vtkExodusIIReader::SIDE_SET,
          vtkExodusIIReader::NODE_SET,
          vtkExodusIIReader::EDGE_BLOCK,
          vtkExodusIIReader::FACE_BLOCK}) {
        for (int i = 0; i < reader->GetNumberOfObjects(type); ++i) reader->SetObjectStatus(type, i, 0);
    }
    for (int i = 0; i < reader->GetNumberOfObjects(vtkExodusIIReader::ELEM_BLOCK); ++i)
        reader->SetObjectStatus(vtkExodusIIReader::ELEM_BLOCK, i, 1);
    return std::make_unique<ExodusReader>(reader.Get(), path);
}

class EnsightReader : public PipelineReader {
public:
    EnsightReader(vtkSmartPointer<vtkAlgorithm> reader, std::string path)
        : PipelineReader(std::move(reader), false), path_(std::move(path)) {}
    std::vector<Leaf> read(std::size_t step) override {
        std::vector<Leaf> leaves = PipelineReader::read(step);
        const std::vector<double> all = times();
        check_ensight_files(path_, step < all.size() ? all[step] : 0, leaves);
        return leaves;
    }

private:
    std::string path_;
};

std::unique_ptr<VtkReader> open_ensight(const std::string& path) {
    expect_ensight_files(path);
    vtkNew<vtkGenericEnSightReader> reader;
    reader->SetCaseFileName(path.c_str());
    reader->ReadAllVariablesOn();
    return std::make_unique<EnsightReader>(reader.Get(), path);
}

class CgnsReader : public PipelineReader {
public:
    explicit CgnsReader(vtkSmartPointer<vtkAlgorithm> reader) : PipelineReader(std::move(reader), false) {}
    std::vector<Leaf> read(std::size_t step) override {
        std::vector<Leaf> leaves = PipelineReader::read(step);
        join_tensors(leaves);
        return leaves;
    }
};

std::unique_ptr<VtkReader> open_cgns(const std::string& path) {
    vtkNew<vtkCGNSReader> reader;
    reader->SetFileName(path.c_str());
    reader->UpdateInformation();
    throw_on_error();
    reader->EnableAllBases();
    reader->EnableAllPointArrays();
    reader->EnableAllCellArrays();
    return std::make_unique<CgnsReader>(reader.Get());
}

std::unique_ptr<VtkReader> open_d3plot(const std::string& path) {
    vtkNew<vtkLSDynaReader> reader;
    reader->SetFileName(path.c_str());
    reader->SetDeformedMesh(0);
    return std::make_unique<PipelineReader>(reader.Get(), false);
}

}  // namespace

std::unique_ptr<VtkReader> open_vtk(const std::string& format, const std::string& path) {
    vtkOutputWindow::SetInstance(words());
    if (format == "vtk") return open_legacy(path);
    if (format == "vtu") return open_xml(path);
    if (format == "pvd") return std::make_unique<PvdReader>(path);
    if (format == "exodus") return open_exodus(path);
    if (format == "ensight") return open_ensight(path);
    if (format == "cgns") return open_cgns(path);
    if (format == "d3plot") return open_d3plot(path);
    throw std::runtime_error("the helper program does not know the format " + format);
}

}  // namespace feelem::exchange
