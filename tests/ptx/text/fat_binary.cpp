#include "tests/ptx/text/fat_binary.h"

#include <elf.h>
#include <zstd.h>

#include <cstring>

#include "tests/ptx/base/findings.h"
#include "tests/ptx/base/numbers.h"

namespace pdr::ptx {

namespace {

/// NVIDIA documents no layout: these fields were read from objects of nvcc 13.0.
struct ImageHead {
    u32 magic;
    u16 version, headBytes;
    u64 bytes;  ///< behind the head
};
struct EntryHead {
    u16 kind;  ///< 1: PTX, 2: cubin
    u16 version;
    u32 headBytes;
    u64 payloadBytes;
    u32 compressedBytes;  ///< 0: not compressed
    u32 options;
    u32 unknown;
    u32 architecture;
    u64 unknown2;
    u64 flags;
    u64 unknown3;
    u64 plainBytes;
};
static_assert(sizeof(ImageHead) == 16 && sizeof(EntryHead) == 64);

constexpr u32 kMagic = 0xBA55ED50;
constexpr u64 kZstd = 0x8000;  ///< a flag
constexpr u16 kPtx = 1;

std::string plain(const EntryHead& head, const char* payload) {
    if (head.compressedBytes == 0)
        return {payload, payload + head.payloadBytes};
    if ((head.flags & kZstd) == 0)
        throw NotKnown("embedded code is compressed in a way other than zstd");
    std::string content(head.plainBytes, '\0');
    const std::size_t got = ZSTD_decompress(content.data(), content.size(), payload, head.compressedBytes);
    if (ZSTD_isError(got))
        throw NotKnown(std::string("embedded code cannot be read: ") + ZSTD_getErrorName(got));
    content.resize(got);
    return content;
}

}  // namespace

std::vector<EmbeddedCode> embeddedCode(const void* image) {
    ImageHead head;
    std::memcpy(&head, image, sizeof head);
    if (head.magic != kMagic)
        throw NotKnown("embedded code begins with no known number");
    std::vector<EmbeddedCode> all;
    const char* at = static_cast<const char*>(image) + head.headBytes;
    for (const char* end = at + head.bytes; at < end;) {
        EntryHead entry;
        std::memcpy(&entry, at, sizeof entry);
        std::string content = plain(entry, at + entry.headBytes);
        if (entry.kind == kPtx)
            content.resize(std::strlen(content.c_str()));
        all.push_back({entry.kind == kPtx, int(entry.architecture), std::move(content)});
        at += entry.headBytes + entry.payloadBytes;
    }
    return all;
}

int registersIn(const std::string& cubin, const std::string& kernel) {
    const auto* head = reinterpret_cast<const Elf64_Ehdr*>(cubin.data());
    const auto* sections = reinterpret_cast<const Elf64_Shdr*>(cubin.data() + head->e_shoff);
    const char* names = cubin.data() + sections[head->e_shstrndx].sh_offset;
    for (int i = 0; i < head->e_shnum; ++i)
        if (names + sections[i].sh_name == ".text." + kernel)
            return int(sections[i].sh_info >> 24);
    return 0;
}

}  // namespace pdr::ptx
