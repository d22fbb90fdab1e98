#include "tests/ptx/runtime/pinned_memory.h"

#include "tests/ptx/machine/pages.h"

namespace pdr::ptx {

namespace {

void protect(u64 begin, u64 bytes, int protection) {
    mprotect(reinterpret_cast<void*>(begin), bytes, protection);
}

}  // namespace

void* PinnedMemory::allocate(u64 bytes) {
    const u64 room = (bytes + kPage - 1) / kPage * kPage;
    void* memory = mmap(nullptr, room, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED)
        return nullptr;
    garbage_.fill(memory, bytes);
    blocks_[reinterpret_cast<u64>(memory)] = {room};
    return memory;
}

bool PinnedMemory::release(void* memory) {
    const auto found = blocks_.find(reinterpret_cast<u64>(memory));
    if (found == blocks_.end())
        return false;
    munmap(memory, found->second.bytes);
    blocks_.erase(found);
    return true;
}

u64 PinnedMemory::beginOf(u64 address) const {
    const auto after = blocks_.upper_bound(address);
    if (after == blocks_.begin())
        return 0;
    const auto& [begin, block] = *std::prev(after);
    return address < begin + block.bytes ? begin : 0;
}

void PinnedMemory::open(u64 address) {
    const u64 begin = beginOf(address);
    protect(begin, blocks_.at(begin).bytes, PROT_READ | PROT_WRITE);
}

void PinnedMemory::count(u64 address, bool writes, int more) {
    const u64 begin = beginOf(address);
    Block& block = blocks_.at(begin);
    (writes ? block.writers : block.readers) += more;
    protect(begin, block.bytes, block.writers > 0 ? PROT_NONE : block.readers > 0 ? PROT_READ : PROT_READ | PROT_WRITE);
}

void PinnedMemory::letAllGo() {
    for (auto& [begin, block] : blocks_) {
        block = {block.bytes};
        protect(begin, block.bytes, PROT_READ | PROT_WRITE);
    }
}

}  // namespace pdr::ptx
