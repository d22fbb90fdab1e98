/// CUDA's functions about memory: taken, freed, copied, cleared.

#include <cstring>
#include <vector>

#include "tests/ptx/runtime/runtime.h"

using namespace pdr::ptx;

namespace {

constexpr u64 kPinnedNames = u64(1) << 40;  ///< names of pinned memory for streams; the device's begin at 1

void touchDevice(Runtime& r, const Work& work, u64 address, u64 bytes, bool writes) {
    r.streams.touches(work, r.memory.numberAt(address), {address, address + bytes}, writes);
}

/// A copy between a place of the device's and one of the host's.
struct Copy {
    u64 device, host, bytes;
    bool isUpload;
    std::vector<u8> staged{};  ///< what pageable memory held when the copy was asked for

    std::string text() const {
        return (isUpload ? "a copy to the device of " : "a copy to the host of ") + std::to_string(bytes) + " bytes";
    }
    void run(Runtime& r) const {
        u8* place = r.memory.at(device, bytes);
        if (place == nullptr) {
            r.findings.tell(text() + ": " + r.memory.describe(device, bytes));
        } else if (isUpload) {
            std::memcpy(place, staged.empty() ? reinterpret_cast<const u8*>(host) : staged.data(), bytes);
            r.memory.markWritten(device, bytes);
        } else {
            std::memcpy(reinterpret_cast<void*>(host), place, bytes);
        }
    }
};

cudaError_t copy(Runtime& r, Copy what, cudaStream_t stream) {
    if (r.memory.at(what.device, what.bytes) == nullptr || r.memory.isDevice(what.host)) {
        r.findings.tell(what.text() + ": " + r.memory.describe(what.device, what.bytes));
        return cudaErrorInvalidValue;
    }
    const u64 host = what.host, device = what.device, bytes = what.bytes, pinned = r.pinned.beginOf(host);
    const bool isUpload = what.isUpload;
    const std::string text = what.text();
    if (pinned != 0)
        r.pinned.hold(host, !isUpload);
    else if (isUpload)
        what.staged.assign(reinterpret_cast<const u8*>(host), reinterpret_cast<const u8*>(host) + bytes);
    const auto run = [&r, what = std::move(what), pinned](const Work&) {
        if (pinned != 0)
            r.pinned.open(what.host);
        what.run(r);
        if (pinned != 0)
            r.pinned.letGo(what.host, !what.isUpload);
    };
    const std::shared_ptr<Work> work = r.streams.add(r.numberOf(stream), text, run);
    touchDevice(r, *work, device, bytes, isUpload);
    if (pinned != 0)
        r.streams.touches(*work, kPinnedNames + pinned, {host, host + bytes}, !isUpload);
    else if (!isUpload)
        r.streams.await(work);  // a copy to pageable memory returns once it has ended
    return cudaSuccess;
}

cudaError_t clear(Runtime& r, u64 address, int value, u64 bytes, cudaStream_t stream) {
    const std::string text = "a clearing of " + std::to_string(bytes) + " bytes";
    if (r.memory.at(address, bytes) == nullptr) {
        r.findings.tell(text + ": " + r.memory.describe(address, bytes));
        return cudaErrorInvalidValue;
    }
    const std::shared_ptr<Work> work = r.streams.add(r.numberOf(stream), text, [=, &r](const Work&) {
        u8* place = r.memory.at(address, bytes);
        if (place == nullptr)
            return r.findings.tell(text + ": " + r.memory.describe(address, bytes));
        std::memset(place, value, bytes);
        r.memory.markWritten(address, bytes);
    });
    touchDevice(r, *work, address, bytes, true);
    return cudaSuccess;
}

}  // namespace

extern "C" {

cudaError_t cudaMalloc(void** memory, std::size_t bytes) {
    return Runtime::get().call("cudaMalloc", [&](Runtime& r) {
        *memory = reinterpret_cast<void*>(r.memory.allocate(bytes));
        return *memory != nullptr ? cudaSuccess : cudaErrorMemoryAllocation;
    });
}
cudaError_t cudaFree(void* memory) {
    return Runtime::get().call("cudaFree", [&](Runtime& r) {
        if (memory == nullptr)
            return cudaSuccess;
        r.streams.awaitAll();  // as drivers do
        if (r.memory.release(reinterpret_cast<u64>(memory)))
            return cudaSuccess;
        r.findings.tell("cudaFree of what is not allocated");
        return cudaErrorInvalidValue;
    });
}
cudaError_t cudaHostAlloc(void** memory, std::size_t bytes, unsigned) {
    return Runtime::get().call("cudaHostAlloc", [&](Runtime& r) {
        *memory = bytes > 0 ? r.pinned.allocate(bytes) : nullptr;
        return *memory != nullptr || bytes == 0 ? cudaSuccess : cudaErrorMemoryAllocation;
    });
}
cudaError_t cudaFreeHost(void* memory) {
    return Runtime::get().call("cudaFreeHost", [&](Runtime& r) {
        r.streams.awaitAll();  // as drivers do
        if (r.pinned.release(memory))
            return cudaSuccess;
        r.findings.tell("cudaFreeHost of what is not pinned");
        return cudaErrorInvalidValue;
    });
}
cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t bytes, cudaMemcpyKind kind, cudaStream_t stream) {
    return Runtime::get().call("cudaMemcpyAsync", [&](Runtime& r) {
        const u64 toAddress = reinterpret_cast<u64>(to), fromAddress = reinterpret_cast<u64>(from);
        if (kind == cudaMemcpyHostToDevice)
            return copy(r, {toAddress, fromAddress, bytes, true}, stream);
        if (kind == cudaMemcpyDeviceToHost)
            return copy(r, {fromAddress, toAddress, bytes, false}, stream);
        throw NotKnown("a copy that is neither to the device nor from it");
    });
}
cudaError_t cudaMemsetAsync(void* memory, int value, std::size_t bytes, cudaStream_t stream) {
    return Runtime::get().call(
        "cudaMemsetAsync", [&](Runtime& r) { return clear(r, reinterpret_cast<u64>(memory), value, bytes, stream); });
}

}  // extern "C"
