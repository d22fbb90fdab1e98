/// CUDA's functions about arrays and textures, as far as volumes of 16-bit numbers need them.

#include <algorithm>
#include <cstring>

#include "tests/ptx/runtime/runtime.h"

using namespace pdr::ptx;

extern "C" {

cudaChannelFormatDesc cudaCreateChannelDesc(int x, int y, int z, int w, cudaChannelFormatKind kind) {
    return {x, y, z, w, kind};
}
cudaError_t cudaMalloc3DArray(cudaArray_t* array, const cudaChannelFormatDesc* format, cudaExtent extent, unsigned) {
    return Runtime::get().call("cudaMalloc3DArray", [&](Runtime& r) {
        if (format->x != 16 || format->y != 0 || format->f != cudaChannelFormatKindSigned)
            throw NotKnown("an array of something else than 16-bit numbers");
        if (std::max({extent.width, extent.height, extent.depth}) > std::size_t(r.settings.largestTexture))
            return cudaErrorInvalidValue;
        const std::size_t voxels = extent.width * extent.height * extent.depth;
        const u64 memory = r.memory.allocate(voxels * sizeof(s16));
        if (memory == 0)
            return cudaErrorMemoryAllocation;
        const Texture texture{std::vector<s16>(voxels), {int(extent.width), int(extent.height), int(extent.depth)}};
        *array = new cudaArray{texture, memory};
        r.garbage.fill((*array)->texture.voxels.data(), voxels * sizeof(s16));
        return cudaSuccess;
    });
}
cudaError_t cudaFreeArray(cudaArray_t array) {
    return Runtime::get().call("cudaFreeArray", [&](Runtime& r) {
        if (r.textures.shows(&array->texture))
            r.findings.tell("cudaFreeArray of what a texture still shows");
        r.streams.awaitAll();
        r.memory.release(array->memory);
        delete array;
        return cudaSuccess;
    });
}
cudaError_t cudaMemcpy3DAsync(const cudaMemcpy3DParms* what, cudaStream_t stream) {
    return Runtime::get().call("cudaMemcpy3DAsync", [&](Runtime& r) {
        const std::size_t width = what->extent.width, rows = what->extent.height * what->extent.depth;
        if (what->kind != cudaMemcpyHostToDevice || what->dstArray == nullptr ||
            what->srcPtr.ysize != what->extent.height)
            throw NotKnown("a 3D copy of that kind");
        std::vector<s16> staged(width * rows);
        for (std::size_t y = 0; y < rows; ++y)
            std::memcpy(staged.data() + y * width, static_cast<const u8*>(what->srcPtr.ptr) + y * what->srcPtr.pitch,
                        width * sizeof(s16));
        r.streams.add(
            r.numberOf(stream), "a copy to a texture",
            [array = what->dstArray, staged = std::move(staged)](const Work&) { array->texture.voxels = staged; });
        return cudaSuccess;
    });
}
cudaError_t cudaCreateTextureObject(cudaTextureObject_t* texture, const cudaResourceDesc* resource,
                                    const cudaTextureDesc* reading, const cudaResourceViewDesc*) {
    return Runtime::get().call("cudaCreateTextureObject", [&](Runtime& r) {
        const bool isClamped = std::ranges::all_of(
            reading->addressMode, [](cudaTextureAddressMode mode) { return mode == cudaAddressModeClamp; });
        if (!isClamped || resource->resType != cudaResourceTypeArray || reading->filterMode != cudaFilterModeLinear ||
            reading->readMode != cudaReadModeNormalizedFloat || reading->normalizedCoords != 0)
            throw NotKnown("a texture of that kind");
        *texture = r.textures.add(&resource->res.array.array->texture);
        return cudaSuccess;
    });
}
/// What still reads the texture ends first, as with drivers.
cudaError_t cudaDestroyTextureObject(cudaTextureObject_t texture) {
    return Runtime::get().call("cudaDestroyTextureObject", [&](Runtime& r) {
        r.streams.awaitAll();
        return r.textures.erase(texture) ? cudaSuccess : cudaErrorInvalidValue;
    });
}
cudaError_t cudaGetTextureObjectResourceDesc(cudaResourceDesc* resource, cudaTextureObject_t texture) {
    return Runtime::get().call("cudaGetTextureObjectResourceDesc", [&](Runtime& r) {
        const Texture* shown = r.textures.find(texture);
        if (shown == nullptr)
            return cudaErrorInvalidValue;
        *resource = {};
        resource->resType = cudaResourceTypeArray;
        // the texture is an array's first member
        resource->res.array.array = reinterpret_cast<cudaArray_t>(const_cast<Texture*>(shown));
        return cudaSuccess;
    });
}

}  // extern "C"
