/// How a warp begins: constants, special registers, and garbage in all others.

#include <algorithm>
#include <cstring>

#include "tests/ptx/machine/warp.h"

namespace pdr::ptx {

namespace {

constexpr std::size_t kFileAlignment = 64;  ///< bytes, as vectors of numbers need

void write(Warp& warp, const Constant& constant, u64 bits) {
    for (u32 lane = 0; lane < kLanes; ++lane)
        std::memcpy(warp.file + constant.slot + lane * constant.bytes, &bits, constant.bytes);
}

/// Returns a special register's value in thread number `thread` of the block of threads `block`.
u32 specialValue(const std::string& name, const Launch& launch, u64 block, u32 thread) {
    const Size3 &grid = launch.grid, &size = launch.block;
    const u32 lane = thread % kLanes;
    const std::pair<const char*, u32> values[] = {
        {"%tid.x", thread % size.x},
        {"%tid.y", thread / size.x % size.y},
        {"%tid.z", thread / size.x / size.y},
        {"%ntid.x", size.x},
        {"%ntid.y", size.y},
        {"%ntid.z", size.z},
        {"%ctaid.x", u32(block % grid.x)},
        {"%ctaid.y", u32(block / grid.x % grid.y)},
        {"%ctaid.z", u32(block / grid.x / grid.y)},
        {"%nctaid.x", grid.x},
        {"%nctaid.y", grid.y},
        {"%nctaid.z", grid.z},
        {"%laneid", lane},
        {"%lanemask_lt", (1u << lane) - 1},
    };
    for (const auto& [known, value] : values)
        if (name == known)
            return value;
    throw NotKnown("special register " + name);
}

}  // namespace

void Warp::prepare(Launch& ofLaunch) {
    launch = &ofLaunch;
    const Program& program = launch->program;
    const bool isFresh = file == nullptr;
    if (isFresh) {
        fileMemory.resize(program.fileBytes + kFileAlignment);
        file = fileMemory.data() + (kFileAlignment - reinterpret_cast<u64>(fileMemory.data()) % kFileAlignment);
        predicates.resize(program.predicates);
        local.resize(std::size_t(program.text.localBytes) * kLanes);
        launch->garbage.fill(file, program.fileBytes);
        launch->garbage.fill(predicates.data(), predicates.size() * sizeof(u32));
        for (const auto& [number, value] : program.constantPredicates)
            predicates[number] = value ? kAllLanes : 0;
    }
    const u64 parameters = reinterpret_cast<u64>(launch->parameters.data());
    for (const Constant& constant : program.constants)
        if (isFresh || constant.isParameter)
            write(*this, constant, constant.bits + (constant.isParameter ? parameters : 0));
}

void Warp::start(u64 block, u32 index) {
    const Program& program = launch->program;
    const u32 threads = u32(launch->block.count()), first = index * kLanes;
    const u32 lanes = std::min<u32>(threads - first, kLanes);
    launch->garbage.fill(local.data(), local.size());
    firstThread = u32(block * threads + first);
    for (const SpecialRegister& special : program.specials)
        for (u32 lane = 0; lane < kLanes; ++lane)
            at<u32>(special.slot)[lane] =
                specialValue(special.name, *launch, block, std::min(first + lane, threads - 1));
    groups.assign(1, {0, lanes == kLanes ? kAllLanes : (1u << lanes) - 1});
}

}  // namespace pdr::ptx
