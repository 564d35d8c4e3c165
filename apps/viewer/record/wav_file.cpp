// SPDX-License-Identifier: Apache-2.0
// A header of 58 bytes (RIFF, fmt for IEEE float, fact, data), then the samples.
#include "viewer/record/wav_file.hpp"

#include "feelem/error.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <string_view>

namespace feelem::viewer {

namespace {

constexpr std::uint32_t kRate = 48000, kChannels = 2, kBytesPerFrame = kChannels * sizeof(float);
constexpr std::uint32_t kHeaderSize = 58;
constexpr std::uint64_t kMostFrames = (0xFFFFFFFFU - kHeaderSize) / kBytesPerFrame;
constexpr std::uint16_t kIeeeFloat = 3;
static_assert(
    std::endian::native == std::endian::little, "a WAV file is little-endian, and so is all we run on"
);

class Header {
public:
    void text(std::string_view word) { put(word.data(), word.size()); }
    void u16(std::uint16_t value) { put(&value, sizeof value); }
    void u32(std::uint32_t value) { put(&value, sizeof value); }
    const std::array<char, kHeaderSize>& bytes() const { return bytes_; }

private:
    void put(const void* from, std::size_t count) {
        std::memcpy(bytes_.data() + at_, from, count);
        at_ += count;
    }
    std::array<char, kHeaderSize> bytes_{};
    std::size_t at_ = 0;
};

}  // namespace

WavFile::WavFile(const std::string& path) : file_(path, std::ios::binary | std::ios::trunc) {
    put_header();
    if (!file_)
        throw Error(Code::WriteFailed, path, "the sound cannot be written here: is the folder writable?");
}

void WavFile::put_header() {
    const auto data = static_cast<std::uint32_t>(frames_ * kBytesPerFrame);
    Header header;
    header.text("RIFF");
    header.u32(kHeaderSize - 8 + data);
    header.text("WAVEfmt ");
    header.u32(18);
    header.u16(kIeeeFloat);
    header.u16(kChannels);
    header.u32(kRate);
    header.u32(kRate * kBytesPerFrame);
    header.u16(kBytesPerFrame);
    header.u16(8 * sizeof(float));
    header.u16(0);
    header.text("fact");
    header.u32(4);
    header.u32(static_cast<std::uint32_t>(frames_));
    header.text("data");
    header.u32(data);
    file_.seekp(0);
    file_.write(header.bytes().data(), kHeaderSize);
    file_.flush();
}

bool WavFile::add(std::span<const float> stereo) {
    const std::uint64_t frames = stereo.size() / kChannels;
    if (is_full_ || !file_ || frames_ + frames > kMostFrames) {
        is_full_ = true;
        return false;
    }
    if (frames == 0) return true;
    // Samples first: a header that promises more than there is would be worse than one that knows less.
    file_.seekp(static_cast<std::streamoff>(kHeaderSize + frames_ * kBytesPerFrame));
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): floats as the bytes they are.
    file_.write(
        reinterpret_cast<const char*>(stereo.data()), static_cast<std::streamsize>(frames * kBytesPerFrame)
    );
    file_.flush();
    if (!file_) return false;
    frames_ += frames;
    put_header();
    return file_.good();
}

}  // namespace feelem::viewer
