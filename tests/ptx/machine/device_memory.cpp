#include "tests/ptx/machine/device_memory.h"

#include <algorithm>

namespace pdr::ptx {

namespace {

constexpr u64 kAlignment = 256;
constexpr u64 kAddressesPerByte = 4;

}  // namespace

DeviceMemory::DeviceMemory(const Settings& settings, Garbage& garbage)
    : garbage_(garbage),
      total_(settings.memoryBytes),
      room_(kAddressesPerByte * std::max(total_, u64(1) << 30)),
      base_(reinterpret_cast<u64>(reserve<u8>(room_, PROT_NONE))),
      storage_(reserve<u8>(room_)),
      pages_(reserve<u32>(room_ / kPage)),
      watch_(settings, room_) {}

u64 DeviceMemory::allocate(u64 bytes) {
    if (bytes > freeBytes())
        return 0;
    const u64 pages = (kAlignment + bytes + kPage - 1) / kPage;
    if (next_ + (pages + 1) * kPage > room_)
        throw NotKnown("all addresses of the device's are used up: none is given twice");
    const u64 low = next_ + kAlignment;
    const u32 number = u32(all_.size());
    std::fill_n(pages_ + next_ / kPage, pages, number);
    next_ += (pages + 1) * kPage;  // one page is left empty behind each
    all_.push_back({low, low + bytes});
    byAddress_[base_ + low] = number;
    used_ += bytes;
    garbage_.fill(storage_ + low, bytes);
    return base_ + low;
}

bool DeviceMemory::release(u64 address) {
    const auto found = byAddress_.find(address);
    if (found == byAddress_.end())
        return false;
    Allocation& one = all_[found->second];
    one.isFreed = true;
    used_ -= one.high - one.low;
    const u64 first = one.low / kPage, pages = (one.high - 1) / kPage - first + 1;
    std::fill_n(pages_ + first, pages, 0);
    madvise(storage_ + first * kPage, pages * kPage, MADV_DONTNEED);
    watch_.forget(first * kPage, pages * kPage);
    byAddress_.erase(found);
    return true;
}

u64 DeviceMemory::Allocation::distanceTo(u64 relative) const {
    return relative < low ? low - relative : relative >= high ? relative - high + 1 : 0;
}

std::string DeviceMemory::describe(u64 address, u64 bytes) const {
    if (!isDevice(address))
        return "the address is not the device's";
    if (all_.size() == 1)
        return "nothing was ever allocated";
    const u64 relative = address - base_;
    const auto nearest = std::min_element(all_.begin() + 1, all_.end(), [&](const Allocation& a, const Allocation& b) {
        return a.distanceTo(relative) < b.distanceTo(relative);
    });
    return std::to_string(bytes) + " bytes at " + std::to_string(s64(relative - nearest->low)) +
           " of an allocation of " + std::to_string(nearest->high - nearest->low) + " bytes" +
           (nearest->isFreed ? ", which was freed" : "");
}

}  // namespace pdr::ptx
