// SPDX-License-Identifier: Apache-2.0
#include "scene/array_writer.hpp"

#include <limits>
#include <memory>

namespace feelem {

void ArrayWriter::begin(const ArraySpec& spec, int component_type) {
    file_->pad_to(4);
    document_->views.push_back({buffer_, file_->size(), 0, spec.target});
    gltf::Accessor accessor;
    accessor.name = spec.name;
    accessor.view = static_cast<int>(document_->views.size()) - 1;
    accessor.component_type = component_type;
    accessor.components = spec.components;
    accessor.count = spec.count;
    document_->accessors.push_back(std::move(accessor));
    digest_ = std::make_unique<Sha256>();
    low_.fill(std::numeric_limits<float>::infinity());
    high_.fill(-std::numeric_limits<float>::infinity());
    block_.reserve(kBlock);
}

int ArrayWriter::end(const ArraySpec& spec) {
    flush();
    gltf::View& view = document_->views.back();
    gltf::Accessor& accessor = document_->accessors.back();
    view.bytes = file_->size() - view.offset;
    if (spec.bounds && accessor.component_type == gltf::kFloat && spec.count > 0) {
        accessor.min.assign(low_.begin(), low_.begin() + spec.components);
        accessor.max.assign(high_.begin(), high_.begin() + spec.components);
    }
    digests_.push_back({spec.name, digest_->hex()});
    return static_cast<int>(document_->accessors.size()) - 1;
}

void ArrayWriter::flush() {
    digest_->add(block_);
    file_->write(block_);
    block_.clear();
}

int ArrayWriter::blob(std::span<const std::byte> bytes) {
    file_->pad_to(4);
    document_->views.push_back({buffer_, file_->size(), bytes.size(), 0});
    file_->write(bytes);
    return static_cast<int>(document_->views.size()) - 1;
}

}  // namespace feelem
