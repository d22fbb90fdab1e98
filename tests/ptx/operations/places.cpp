#include "tests/ptx/operations/places.h"

namespace pdr::ptx {

u8* globalPlace(Warp& w, const Instruction& i, int lane, u64 address, Access access) {
    const u32 bytes = u32(i.bytes) * i.count;
    DeviceMemory& memory = w.launch->memory;
    if (address % bytes != 0) [[unlikely]]
        w.fault(i, lane, kMisalignedAddress, "the address is not a multiple of " + std::to_string(bytes));
    u8* place = memory.at(address, bytes);
    if (place == nullptr) [[unlikely]]
        w.fault(i, lane, kIllegalAddress, memory.describe(address, bytes));
    if (memory.watches()) [[unlikely]] {
        const char* wrong = memory.watch(address, bytes, access, w.accessor(lane));
        if (wrong != nullptr)
            w.tell(i, wrong);
        w.launch->touched.add(memory.numberAt(address), address, bytes, isWrite(access));
    }
    return place;
}

u8* localPlace(Warp& w, const Instruction& i, int lane, u64 address) {
    const u32 bytes = u32(i.bytes) * i.count, room = w.launch->program.text.localBytes;
    if (address + bytes > room || address % bytes != 0)
        w.fault(i, lane, kIllegalAddress, "local memory at " + std::to_string(address) + " of " + std::to_string(room));
    return w.local.data() + std::size_t(lane) * room + address;
}

}  // namespace pdr::ptx
