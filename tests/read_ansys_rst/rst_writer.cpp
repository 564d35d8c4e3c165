// SPDX-License-Identifier: Apache-2.0
#include "read_ansys_rst/rst_writer.hpp"

#include <algorithm>
#include <cstring>

namespace feelem::test {
namespace {

using Words = std::vector<std::int32_t>;

std::int32_t low(std::int64_t value) {
    return static_cast<std::int32_t>(value & 0xFFFFFFFF);
}
std::int32_t high(std::int64_t value) {
    return static_cast<std::int32_t>(value >> 32);
}

/// Text in words, the first character in the highest byte.
void put_text(Words& header, std::size_t first, std::size_t count, std::string text) {
    text.resize(4 * count, ' ');
    for (std::size_t i = 0; i < 4 * count; ++i) {
        auto& word = header[first - 1 + i / 4];
        word = static_cast<std::int32_t>(
            static_cast<std::uint32_t>(word) << 8 | static_cast<unsigned char>(text[i])
        );
    }
}

class Writer {
public:
    explicit Writer(const WrittenModel& model) : model_(model) {}

    std::string write() {
        write_heads();
        Words ids;
        for (const auto& element : model_.elements) ids.push_back(element.id);
        set_pointer(head_, 15, 46, file_.add(model_.storage));
        set_pointer(head_, 14, 45, file_.add(ids));
        places_ = file_.add(Words(2 * table_));
        set_pointer(head_, 11, 41, places_);
        std::vector<double> times(table_);
        Words steps(3 * table_);
        for (std::size_t i = 0; i < model_.sets.size(); ++i) {
            times[i] = model_.sets[i].time;
            steps[3 * i] = model_.sets[i].load_step;
            steps[3 * i + 1] = model_.sets[i].substep;
            steps[3 * i + 2] = static_cast<std::int32_t>(i) + 1;
        }
        if (!model_.harmonics.empty()) set_pointer(head_, 17, 44, file_.add(model_.harmonics));
        set_pointer(head_, 12, 42, file_.add(times));
        set_pointer(head_, 13, 43, file_.add(steps));
        write_geometry();
        for (std::size_t i = 0; i < model_.sets.size(); ++i) write_set(i, model_.sets[i]);
        return file_.bytes();
    }

private:
    void set_pointer(std::size_t record, std::size_t low_item, std::size_t high_item, std::size_t value) {
        file_.set_item(record, low_item, low(static_cast<std::int64_t>(value)));
        file_.set_item(record, high_item, high(static_cast<std::int64_t>(value)));
    }

    void write_heads() {
        Words standard(100);
        standard[0] = 12;
        standard[2] = model_.time;
        standard[3] = 20261122;
        put_text(standard, 10, 1, "25.2");
        put_text(standard, 41, 20, model_.title);
        file_.add(standard);
        Words head(80);
        head[2] = static_cast<std::int32_t>(model_.storage.size());
        head[3] = static_cast<std::int32_t>(table_);
        head[4] = static_cast<std::int32_t>(model_.dofs.size());
        head[6] = static_cast<std::int32_t>(model_.elements.size());
        head[7] = model_.analysis;
        head[8] = static_cast<std::int32_t>(model_.sets.size());
        head[19] = model_.units;
        head[18] = model_.sector_elements;
        head[20] = model_.sectors;
        head[21] = model_.has_axis ? 12 : 0;
        head[31] = model_.sector_nodes;
        head[32] = model_.is_complex ? 1 : 0;
        head[39] = model_.has_principal ? 0 : 1;
        head[48] = model_.nodes_of_all > 0 ? model_.nodes_of_all : head[2];
        head_ = file_.add(head);
    }

    void write_geometry() {
        Words geometry(80);
        geometry[3] = static_cast<std::int32_t>(model_.nodes.size());
        geometry[4] = static_cast<std::int32_t>(model_.elements.size());
        geometry[48] = static_cast<std::int32_t>(model_.components.size());
        const std::size_t at = file_.add(geometry);
        set_pointer(head_, 16, 47, at);

        const std::size_t types = file_.add(Words(model_.types.size()));
        set_pointer(at, 21, 22, types);
        for (std::size_t i = 0; i < model_.types.size(); ++i) {
            Words type(200);
            type[0] = static_cast<std::int32_t>(i) + 1;
            type[1] = model_.types[i].routine;
            type[2] = model_.types[i].keyopt1;
            type[9] = model_.types[i].keyopt8;
            type[93] = model_.types[i].corners;
            file_.set_item(types, i + 1, static_cast<std::int32_t>(file_.add(type) - types));
        }
        if (model_.has_axis) {
            const std::size_t systems = file_.add(Words(1));
            set_pointer(at, 25, 26, systems);
            std::vector<double> system(24);
            system[0] = system[4] = system[8] = 1;
            system[20] = 1;
            system[21] = 12;
            file_.set_item(systems, 1, static_cast<std::int32_t>(file_.add(system) - systems));
        }
        set_pointer(at, 27, 28, file_.words());
        for (const auto& node : model_.nodes) file_.add(std::vector<double>(node.begin(), node.end()));

        const std::size_t table = file_.add(Words(2 * model_.elements.size()));
        set_pointer(at, 29, 30, table);
        for (std::size_t i = 0; i < model_.elements.size(); ++i) {
            const WrittenElement& element = model_.elements[i];
            Words row{element.material, element.type, 1, 1, 0, 0, 0, 0, element.id, 0};
            row.insert(row.end(), element.nodes.begin(), element.nodes.end());
            set_pointer(table, 2 * i + 1, 2 * i + 2, file_.add(row) - table);
        }
        if (!model_.components.empty()) set_pointer(at, 51, 52, file_.words());
        for (const WrittenComponent& component : model_.components) {
            Words row(9);
            row[0] = component.of_nodes ? 1 : 2;
            put_text(row, 2, 8, component.name);
            row.insert(row.end(), component.members.begin(), component.members.end());
            file_.add(row);
        }
    }

    void write_set(std::size_t i, const WrittenSet& set) {
        Words head(200);
        head[1] = static_cast<std::int32_t>(model_.elements.size());
        head[2] = static_cast<std::int32_t>(model_.storage.size());
        head[4] = set.load_step;
        head[5] = set.substep;
        head[7] = static_cast<std::int32_t>(set.reactions.size());
        head[18] = set.imaginary ? 1 : 0;
        head[19] = static_cast<std::int32_t>(model_.dofs.size());
        for (std::size_t k = 0; k < model_.dofs.size(); ++k) head[20 + k] = model_.dofs[k];
        for (const WrittenElementRecord& record : set.element_records)
            head[146] |= 1 << static_cast<int>(record.table_entry);
        const std::size_t at = file_.add(head);
        set_pointer(places_, i + 1, table_ + i + 1, at);
        file_.add(std::vector<double>(100, set.time));
        if (!set.solution.empty()) {
            set_pointer(at, 105, 106, file_.add(set.solution) - at);
            if (!set.rows.empty()) file_.add(set.rows);
        }
        if (!set.reactions.empty()) {
            Words index;
            for (const std::int64_t place : set.reaction_at) {
                index.push_back(low(place));
                index.push_back(high(place));
            }
            set_pointer(at, 107, 108, file_.add(index) - at);
            file_.add(set.reactions);
        }
        if (!set.element_records.empty()) write_element_records(at, set);
    }

    void write_element_records(std::size_t head, const WrittenSet& set) {
        const std::size_t index = file_.add(Words(2 * model_.elements.size()));
        set_pointer(head, 119, 120, index - head);
        for (std::size_t i = 0; i < model_.elements.size(); ++i) {
            bool has = false;
            for (const WrittenElementRecord& record : set.element_records) has = has || record.element == i;
            if (!has) continue;
            const std::size_t table = file_.add(Words(25));
            set_pointer(index, 2 * i + 1, 2 * i + 2, table - index);
            for (const WrittenElementRecord& record : set.element_records) {
                if (record.element != i) continue;
                const std::int32_t place = record.zeros > 0
                                               ? -static_cast<std::int32_t>(record.zeros)
                                               : static_cast<std::int32_t>(file_.add(record.values) - table);
                file_.set_item(table, record.table_entry, place);
            }
        }
    }

    const WrittenModel& model_;
    RecordFile file_;
    std::size_t head_ = 0, places_ = 0;
    std::size_t table_ = std::max<std::size_t>(10, model_.sets.size());
};

}  // namespace

std::size_t RecordFile::add(std::uint8_t flags, std::string payload) {
    const std::size_t at = words();
    payload.resize((payload.size() + 3) / 4 * 4, '\0');
    const auto length = static_cast<std::int32_t>(payload.size() / 4);
    Bytes head, foot;
    head.put(length).put(static_cast<std::uint32_t>(flags) << 24);
    foot.put(length);
    bytes_ += head.text() + payload + foot.text();
    return at;
}

std::size_t RecordFile::add(const std::vector<std::int32_t>& values) {
    return add(kIntegers, Bytes().put_all(values).text());
}

std::size_t RecordFile::add(const std::vector<double>& values) {
    return add(kReals, Bytes().put_all(values).text());
}

void RecordFile::set_item(std::size_t record, std::size_t item, std::int32_t value) {
    std::memcpy(bytes_.data() + 4 * (record + 1 + item), &value, sizeof value);
}

std::string write_rst(const WrittenModel& model) {
    return Writer(model).write();
}

WrittenModel two_bricks() {
    WrittenModel model;
    model.types = {{185, 8, 0, 0}};
    // Nodes 10 to 120, x fastest.
    for (int i = 0; i < 12; ++i) {
        model.nodes.push_back({10.0 * (i + 1), double(i % 3), double(i / 3 % 2), double(i / 6), 0, 0, 0});
        model.storage.push_back(10 * (12 - i));
    }
    model.elements = {
        {7, 1, 1, {10, 20, 50, 40, 70, 80, 110, 100}},
        {8, 1, 2, {20, 30, 60, 50, 80, 90, 120, 110}},
    };
    return model;
}

}  // namespace feelem::test
