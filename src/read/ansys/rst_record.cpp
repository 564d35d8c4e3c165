// SPDX-License-Identifier: Apache-2.0
// Must: give the numbers of a record exactly as they stand, from any of Ansys' compressions.
// Assumes: nothing. Lengths, windows and masks are checked before anything is allocated or written.
// Algorithm: the byte 7 of a record says what its numbers are (bit 7 integers, bit 6 half as long) and how
// they are packed: bit 3 a mask of the values that are not zero, bit 4 runs ("windows") of values, both bits
// several such runs side by side, one for each group of columns; bit 5 the whole once more through zlib.
// Data: the payload stays in the mapped file; only the unpacked values are held.
#include "read/ansys/rst_record.hpp"

#include "base/byte_reader.hpp"

#include "feelem/error.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

namespace feelem::rst {
namespace {

static_assert(std::endian::native == std::endian::little, "records are copied as they are");

constexpr std::uint8_t kInteger = 0x80;
constexpr std::uint8_t kHalf = 0x40;
constexpr std::uint8_t kZlib = 0x20;
constexpr std::uint8_t kWindows = 0x10;
constexpr std::uint8_t kMask = 0x08;

/// Numbers of one kind out of packed bytes. `Stored` as in the file, `Out` as the caller wants them.
template <class Stored, class Out>
class Unpacker {
public:
    Unpacker(std::span<const std::byte> bytes, std::size_t most, const Records& records, Word at)
        : bytes_(bytes), most_(most), records_(records), record_at_(at) {}

    void run(std::uint8_t flags, std::vector<Out>& out) {
        out.clear();
        switch (flags & (kWindows | kMask)) {
        case 0: plain(out); break;
        case kMask: masked(out); break;
        case kWindows: {
            out.resize(size_of_record());
            windows(out.size(), [&](std::size_t i, Out value) { out[i] = value; });
            break;
        }
        default: groups(out); break;
        }
    }

private:
    [[noreturn]] void bad(const std::string& text) const {
        throw Error(
            Code::BadStructure,
            records_.where(record_at_),
            text + ". Was the file copied whole, and in binary mode?"
        );
    }

    template <class T>
    T take() {
        if (bytes_.size() - at_ < sizeof(T)) bad("a packed record ends in the middle of its values");
        T value;
        std::memcpy(&value, bytes_.data() + at_, sizeof(T));
        at_ += sizeof(T);
        return value;
    }

    std::size_t size_of_record() {
        const auto size = take<std::int32_t>();
        if (size < 0 || static_cast<std::size_t>(size) > most_) {
            bad(fmt::format("a packed record says that it holds {} values, at most {} can be", size, most_));
        }
        return static_cast<std::size_t>(size);
    }

    void plain(std::vector<Out>& out) {
        const std::size_t count = std::min(most_, bytes_.size() / sizeof(Stored));
        out.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            Stored value;
            std::memcpy(&value, bytes_.data() + i * sizeof(Stored), sizeof(Stored));
            out[i] = static_cast<Out>(value);
        }
    }

    void masked(std::vector<Out>& out) {
        const std::size_t size = size_of_record();
        const auto mask = take<std::uint32_t>();
        if (size > 32) bad(fmt::format("a mask of 32 bits cannot stand for {} values", size));
        out.resize(size);
        for (std::size_t i = 0; i < size; ++i) {
            if ((mask >> i & 1) != 0) out[i] = static_cast<Out>(take<Stored>());
        }
    }

    /// Calls put(place, value) for the values that are there; the others are zero.
    template <class Put>
    void windows(std::size_t size, Put put) {
        const auto count = take<std::int32_t>();
        std::size_t filled = 0;
        for (std::int32_t i = 0; i < count; ++i) {
            const std::int64_t place = take<std::int32_t>();
            const std::int64_t length = place > 0 ? 1 : take<std::int32_t>();
            const auto start = static_cast<std::size_t>(place > 0 ? place : -place);
            const auto run = static_cast<std::size_t>(length < 0 ? -length : length);
            filled += run;
            if (start > size || run > size - start || filled > size) {
                bad(fmt::format("a run of {} values at {} lies outside its record of {}", run, start, size));
            }
            if (length < 0) {
                const Out value = static_cast<Out>(take<Stored>());
                for (std::size_t k = 0; k < run; ++k) put(start + k, value);
            } else {
                if (run > (bytes_.size() - at_) / sizeof(Stored)) bad("a run of values is cut off");
                for (std::size_t k = 0; k < run; ++k) put(start + k, static_cast<Out>(take<Stored>()));
            }
        }
    }

    /// Groups of columns side by side (UX UY UZ | ROTX ROTY ROTZ), each packed by itself.
    void groups(std::vector<Out>& out) {
        const std::size_t size = size_of_record();
        const auto count = take<std::int32_t>();
        if (count < 1 || static_cast<std::size_t>(count) > bytes_.size() / 4)
            bad(fmt::format("a packed record says that it has {} groups of columns", count));
        std::vector<std::size_t> widths;
        std::size_t total = 0;
        for (std::int32_t i = 0; i < count; ++i) {
            const auto width = take<std::int32_t>();
            if (width < 1 || static_cast<std::size_t>(width) > size - total)
                bad(fmt::format("a group of {} columns does not fit a record of {}", width, size));
            widths.push_back(static_cast<std::size_t>(width));
            total += widths.back();
        }
        if (size % total != 0) bad(fmt::format("{} values are no whole rows of {} columns", size, total));
        out.resize(size);
        const std::size_t rows = size / total;
        std::size_t first = 0;
        for (const std::size_t width : widths) {
            windows(rows * width, [&](std::size_t i, Out value) {
                out[i / width * total + first + i % width] = value;
            });
            first += width;
        }
    }

    std::span<const std::byte> bytes_;
    std::size_t most_;
    const Records& records_;
    Word record_at_;
    std::size_t at_ = 0;
};

/// The bytes of a zlib stream. Its place in the payload is known from no real file, so it is looked for
/// behind up to two counts; the stream's own checksum then says whether it was one.
std::vector<std::byte> inflate_payload(std::span<const std::byte> payload, std::size_t most_bytes) {
    for (const std::size_t start : {std::size_t{0}, std::size_t{4}, std::size_t{8}}) {
        if (payload.size() < start + 2) break;
        const auto first = static_cast<unsigned>(payload[start]);
        const auto second = static_cast<unsigned>(payload[start + 1]);
        if ((first & 15) != 8 || (first * 256 + second) % 31 != 0) continue;
        z_stream stream{};
        if (inflateInit(&stream) != Z_OK) break;
        std::vector<std::byte> out;
        // zlib's interface is not const, but it only reads.
        stream.next_in =
            const_cast<Bytef*>(reinterpret_cast<const Bytef*>(payload.data() + start));  // NOLINT
        stream.avail_in =
            static_cast<uInt>(std::min<std::size_t>(payload.size() - start, std::numeric_limits<uInt>::max())
            );
        int state = Z_OK;
        while (state == Z_OK && out.size() <= most_bytes) {
            constexpr std::size_t kChunk = 1u << 16;
            const std::size_t before = out.size();
            out.resize(before + kChunk);
            stream.next_out = reinterpret_cast<Bytef*>(out.data() + before);  // NOLINT
            stream.avail_out = kChunk;
            state = inflate(&stream, Z_NO_FLUSH);
            out.resize(before + kChunk - stream.avail_out);
        }
        inflateEnd(&stream);
        if (state == Z_STREAM_END) return out;
    }
    return {};
}

template <class Out>
void unpack_any(const Records& records, const Record& record, std::size_t most, std::vector<Out>& out) {
    const bool integer = (record.flags & kInteger) != 0;
    if (std::is_integral_v<Out> && !integer)
        throw Error(
            Code::BadStructure,
            records.where(record.at),
            "this record holds reals where whole numbers must be"
        );
    std::span<const std::byte> bytes = record.payload;
    std::vector<std::byte> inflated;
    if ((record.flags & kZlib) != 0) {
        // Runs of one value each take twelve bytes a value.
        inflated = inflate_payload(bytes, most > (1u << 30) ? std::size_t{1} << 30 : most * 16 + 4096);
        if (inflated.empty() && !bytes.empty()) {
            throw Error(
                Code::BadStructure,
                records.where(record.at),
                "this record is packed with zlib in a way that is not known. Write the results again after "
                "/FCOMP,RST,0, and please send us the file."
            );
        }
        bytes = inflated;
    }
    const bool half = (record.flags & kHalf) != 0;
    if (integer && half) {
        Unpacker<std::int16_t, Out>(bytes, most, records, record.at).run(record.flags, out);
    } else if (integer) {
        Unpacker<std::int32_t, Out>(bytes, most, records, record.at).run(record.flags, out);
    } else if constexpr (std::is_floating_point_v<Out>) {
        if (half) {
            Unpacker<float, Out>(bytes, most, records, record.at).run(record.flags, out);
        } else {
            Unpacker<double, Out>(bytes, most, records, record.at).run(record.flags, out);
        }
    }
}

}  // namespace

std::string Records::where(Word at) const {
    constexpr Word kMost = std::numeric_limits<Word>::max() / 4;
    return input_.where_byte(at > kMost ? input_.size() : at * 4);
}

Record Records::find(Word at) const {
    if (at >= words()) {
        throw Error(
            Code::Truncated,
            input_.where_byte(input_.size()),
            fmt::format(
                "a record must begin at byte {}, behind the end of the file. Was it copied whole?", at * 4
            )
        );
    }
    ByteReader reader(input_, at * 4);
    const auto length = reader.read<std::int32_t>();
    const auto flags = reader.read<std::uint32_t>();
    if (length < 0) throw Error(Code::BadStructure, where(at), fmt::format("a record of {} words", length));
    const auto words = static_cast<Word>(length);
    Record record{reader.take(words * 4), static_cast<std::uint8_t>(flags >> 24), at, at + words + 3};
    const auto again = reader.read<std::int32_t>();
    if (again != length) {
        throw Error(
            Code::BadStructure,
            where(at),
            fmt::format("a record begins with the length {} and ends with {}: it is damaged", length, again)
        );
    }
    return record;
}

void Records::unpack(const Record& record, std::size_t most, std::vector<std::int32_t>& out) const {
    unpack_any(*this, record, most, out);
}

void Records::unpack(const Record& record, std::size_t most, std::vector<double>& out) const {
    unpack_any(*this, record, most, out);
}

std::size_t Records::count(const Record& record) {
    if ((record.flags & (kZlib | kWindows | kMask)) == 0) {
        const std::size_t width = (record.flags & kInteger) != 0 ? 4 : 8;
        return record.payload.size() / ((record.flags & kHalf) != 0 ? width / 2 : width);
    }
    if ((record.flags & kZlib) != 0 || record.payload.size() < 4) return 0;
    std::int32_t size = 0;
    std::memcpy(&size, record.payload.data(), sizeof size);
    return size > 0 ? static_cast<std::size_t>(size) : 0;
}

Reals::Reals(const Records& records, const Record& record, std::size_t most) {
    is_half_ = (record.flags & kHalf) != 0;
    if ((record.flags & (kInteger | kZlib | kWindows | kMask)) == 0) {
        bytes_ = record.payload.data();
        size_ = std::min(most, Records::count(record));
        return;
    }
    is_half_ = false;
    records.unpack(record, most, unpacked_);
    bytes_ = reinterpret_cast<const std::byte*>(unpacked_.data());
    size_ = unpacked_.size();
}

std::vector<std::int32_t> Records::integers(Word at, std::size_t most) const {
    std::vector<std::int32_t> out;
    unpack(find(at), most, out);
    return out;
}

std::vector<double> Records::reals(Word at, std::size_t most) const {
    std::vector<double> out;
    unpack(find(at), most, out);
    return out;
}

}  // namespace feelem::rst
