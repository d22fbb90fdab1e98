#pragma once
/// A scene in a GPU's memory. What did not change since the last one is not sent again; its acceleration structure is
/// built there.

#include <memory>

#include "render/base/errors.h"
#include "render/device/gpu/bounds_kernels.h"
#include "render/device/gpu/gpu_array.h"
#include "render/device/gpu/gpu_texture.h"
#include "render/kernel/transport/majorant_traversal.h"
#include "render/prepare/flatten.h"

namespace pdr {

template <Gpu G>
class GpuScene {
  public:
    explicit GpuScene(G& gpu) : gpu_(gpu) {}

    /// Uploads `scene`, flattened, and builds its acceleration structure. Errors: it does not fit (needed, free), or
    /// the GPU's; then there is no scene.
    Result<void> upload(std::shared_ptr<const PreparedScene> scene);

    /// Forgets the scene and releases its memory.
    Result<void> close();

    /// Returns the scene as it was uploaded; null if there is none.
    const std::shared_ptr<const PreparedScene>& prepared() const { return scene_; }
    /// Returns an error if there is no scene: samples would read memory that is gone.
    Result<void> isThere() const {
        if (scene_)
            return {};
        return Error{phrase("there is no scene on the device"), gpu_.name(),
                     phrase("It was refused, or the device failed before.")};
    }
    /// Returns the scene with all its pointers into the GPU's memory.
    const FlatScene& flat() const { return flat_; }

    /// Returns the device memory for a volume of that many voxels and its acceleration structure, without its texture
    /// [bytes].
    static std::size_t bytesFor(ivec3 voxels);

  private:
    static bool wantsTexture(const PreparedScene& scene);
    Result<void> room(const PreparedScene& scene, std::size_t needed) const;
    Result<void> takeVolume(const PreparedScene& scene);
    Result<void> takeTexture(const PreparedScene& scene);
    Result<void> takeMask(const PreparedScene& scene);
    Result<void> takeParts(const PreparedScene& scene);
    void sendPartTables(const PartTables& parts);
    void sendTables(const PreparedScene& scene);
    void sendEnvironment(const PreparedScene& scene);
    Result<void> bound(const PreparedScene& scene);
    void boundView(const PreparedScene& scene);
    void forget();

    G& gpu_;
    std::shared_ptr<const PreparedScene> scene_;
    FlatScene flat_{};

    GpuArray<G, std::int16_t> voxels_{gpu_};
    GpuTexture<G> texture_{gpu_};
    std::shared_ptr<const Mask> mask_;
    GpuArray<G, std::int16_t> weights_{gpu_};
    std::shared_ptr<const LabelMap> map_;
    GpuArray<G, std::uint8_t> labels_{gpu_};
    std::shared_ptr<const CellCurves> cells_;
    GpuArray<G, std::uint8_t> onlyCurve_{gpu_};
    GpuArray<G, HuRange> ranges_{gpu_};
    GpuArray<G, float> fine_{gpu_}, coarse_{gpu_};
    GpuArray<G, BoundsSummary> summary_{gpu_};
    PinnedArray<G, BoundsSummary> summaryHere_{gpu_};
    GpuTable<G, OpacityPiece> pieces_{gpu_};
    GpuTable<G, Material> materials_{gpu_};
    GpuTable<G, std::uint16_t> pieceAt_{gpu_};
    GpuTable<G, std::uint8_t> materialOf_{gpu_};
    GpuTable<G, std::uint8_t> curveOf_{gpu_};
    GpuTable<G, OpacityPiece> partPieces_{gpu_};
    GpuTable<G, Material> partMaterials_{gpu_};
    GpuTable<G, std::uint16_t> partPieceAt_{gpu_};
    GpuTable<G, FlatTransferFunction> curves_{gpu_};
    GpuTable<G, float> optics_{gpu_};
    GpuTable<G, FlatLight> lights_{gpu_};
    GpuTable<G, float> lightSums_{gpu_};
    GpuTable<G, FlatLightNode> lightNodes_{gpu_};
    GpuTable<G, FlatPlane> planes_{gpu_};
    GpuTable<G, SobolTable> sobol_{gpu_};
    std::shared_ptr<const EnvironmentTables> environment_;
    GpuArray<G, vec3> texels_{gpu_};
    GpuArray<G, float> density_{gpu_}, rowSums_{gpu_}, columnSums_{gpu_};
    GpuArray<G, OrderedDepths> orderedDepths_{gpu_};
    GpuArray<G, WideCells> wide_{gpu_};
    GpuArray<G, CoveredBlocks> wideCells_{gpu_};
    GpuArray<G, vec2> depths_{gpu_};
};

template <Gpu G>
std::size_t GpuScene<G>::bytesFor(ivec3 voxels) {
    const auto cells = [](ivec3 size) { return std::size_t(size.x) * size.y * size.z; };
    const std::size_t coarse = cells(coarseCells(voxels));
    return cells(voxels) * sizeof(std::int16_t) + coarse * 64 * (sizeof(HuRange) + sizeof(float)) +
           coarse * sizeof(float);
}

template <Gpu G>
Result<void> GpuScene<G>::upload(std::shared_ptr<const PreparedScene> scene) {
    const bool sameVolume = scene_ && scene_->volume == scene->volume;
    const bool sameBounds = scene_ && sameMajorants(*scene_, *scene);
    scene_ = nullptr;
    // Upload voxels, texture, mask and labels
    if (!sameVolume)
        if (Result<void> fits = takeVolume(*scene); !fits)
            return fits;
    if (Result<void> fits = takeTexture(*scene); !fits)
        return fits;
    if (Result<void> fits = takeMask(*scene); !fits)
        return fits;
    if (Result<void> fits = takeParts(*scene); !fits)
        return fits;
    // Let the scene point to device memory
    const FlatMajorants bounds = flat_.majorants;
    flat_ = scene->flat;
    flat_.mask.voxels = weights_.data();
    flat_.volume.voxels = voxels_.data();
    flat_.volume.texture = texture_.handle();
    sendTables(*scene);
    sendPartTables(scene->parts);
    sendEnvironment(*scene);
    // Rebuild the majorants if they have changed
    if (sameBounds)
        flat_.majorants = bounds;
    else if (Result<void> bounded = bound(*scene); !bounded)
        return bounded;
    boundView(*scene);
    if (Result<void> done = takeStatus(gpu_); !done) {
        forget();
        return done;
    }
    scene_ = std::move(scene);
    return {};
}

/// Returns whether a texture is needed. One that cannot hold every voxel would be another volume: filtering stays exact
/// then.
template <Gpu G>
bool GpuScene<G>::wantsTexture(const PreparedScene& scene) {
    return scene.flat.fastFiltering && textureHolds(scene.volume->storedRange());
}

template <Gpu G>
Result<void> GpuScene<G>::room(const PreparedScene& scene, std::size_t needed) const {
    if (Result<void> works = takeStatus(gpu_); !works)
        return works;
    const auto [total, free] = gpu_.memory();
    if (needed <= free)
        return {};
    if (total == 0)
        return Error{phrase("it does not say how much memory it has, and is broken or lost"), gpu_.name(),
                     phrase("Render on the CPU."), ErrorKind::deviceLost};
    return Error{phrase("the volume does not fit into its memory: %1 are needed, %2 are free", bytesText(needed),
                        bytesText(free)),
                 gpu_.name(),
                 wantsTexture(scene) ? phrase("Choose exact filtering, which needs less, import a part of the series, "
                                              "close programs that use the device, or render on the CPU.")
                                     : phrase("Import a part of the series, close programs that use the device, or "
                                              "render on the CPU."),
                 ErrorKind::memory};
}

template <Gpu G>
Result<void> GpuScene<G>::takeVolume(const PreparedScene& scene) {
    const Volume& volume = *scene.volume;
    texture_.free();
    voxels_.free();
    ranges_.free();
    fine_.free();
    coarse_.free();
    const std::size_t texture = wantsTexture(scene) ? GpuTexture<G>::bytesFor(volume.size()) : 0;
    if (Result<void> fits = room(scene, bytesFor(volume.size()) + texture); !fits)
        return fits;
    const ivec3 coarse = coarseCells(volume.size()), fine = coarse * kFinePerCoarse;
    const std::size_t coarseCount = std::size_t(coarse.x) * coarse.y * coarse.z;
    voxels_.assign(volume.voxels());
    ranges_.resize(coarseCount * 64);
    fine_.resize(coarseCount * 64);
    coarse_.resize(coarseCount);
    gpu_.launch(BuildRangesKernel{voxels_.data(), volume.size(), fine, ranges_.data()}, std::int64_t(ranges_.size()),
                GpuStream::compute);
    return takeStatus(gpu_);
}

/// Makes the texture, which is kept as long as the volume is, or releases it if it is not requested any more.
template <Gpu G>
Result<void> GpuScene<G>::takeTexture(const PreparedScene& scene) {
    if (!wantsTexture(scene)) {
        texture_.free();
        return {};
    }
    if (texture_.handle() != 0)
        return {};
    const Volume& volume = *scene.volume;
    if (Result<void> fits = room(scene, GpuTexture<G>::bytesFor(volume.size())); !fits)
        return fits;
    texture_.make(volume.voxels().data(), volume.size());
    return takeStatus(gpu_);
}

/// Uploads the mask, which is kept as long as it is the scene's.
template <Gpu G>
Result<void> GpuScene<G>::takeMask(const PreparedScene& scene) {
    if (mask_ == scene.mask)
        return {};
    mask_ = nullptr;
    weights_.free();
    if (!scene.mask)
        return {};
    if (Result<void> fits = room(scene, scene.mask->weights().size() * sizeof(std::int16_t)); !fits)
        return fits;
    weights_.assign(scene.mask->weights());
    if (Result<void> sent = takeStatus(gpu_); !sent)
        return sent;
    mask_ = scene.mask;
    return {};
}

/// Uploads the labels, which are kept as long as they are the scene's, and the curves of cells.
template <Gpu G>
Result<void> GpuScene<G>::takeParts(const PreparedScene& scene) {
    const PartTables& parts = scene.parts;
    if (map_ != parts.map) {
        map_ = nullptr;
        labels_.free();
        if (!parts.empty()) {
            if (Result<void> fits = room(scene, parts.map->labels.size()); !fits)
                return fits;
            labels_.assign(parts.map->labels);
        }
    }
    if (cells_ != parts.cells) {
        cells_ = nullptr;
        onlyCurve_.free();
        if (!parts.empty())
            onlyCurve_.assign(*parts.cells);
    }
    if (Result<void> sent = takeStatus(gpu_); !sent)
        return sent;
    map_ = parts.map;
    cells_ = parts.cells;
    return {};
}

template <Gpu G>
void GpuScene<G>::sendPartTables(const PartTables& parts) {
    if (parts.empty())
        return;
    materialOf_.update(parts.materialOf);
    curveOf_.update(parts.curveOf);
    partPieces_.update(parts.pieces);
    partMaterials_.update(parts.materials);
    partPieceAt_.update(parts.pieceAt);
    std::vector<FlatTransferFunction> curves = parts.curves;
    for (FlatTransferFunction& curve : curves) {
        curve.pieces = partPieces_.data() + (curve.pieces - parts.pieces.data());
        curve.materials = partMaterials_.data() + (curve.materials - parts.materials.data());
        curve.pieceAt = partPieceAt_.data() + (curve.pieceAt - parts.pieceAt.data());
    }
    curves_.update(curves);
    flat_.parts.labels = labels_.data();
    flat_.parts.materialOf = materialOf_.data();
    flat_.parts.curveOf = curveOf_.data();
    flat_.parts.onlyCurve = onlyCurve_.data();
    flat_.parts.curves = curves_.data();
}

template <Gpu G>
void GpuScene<G>::sendTables(const PreparedScene& scene) {
    pieces_.update(scene.tables.pieces);
    materials_.update(scene.tables.materials);
    pieceAt_.update(scene.tables.pieceAt);
    optics_.update(scene.optics);
    lights_.update(scene.lights);
    lightSums_.update(scene.lightTables.sums);
    lightNodes_.update(scene.lightTables.nodes);
    planes_.update(scene.clipPlanes);
    sobol_.update({scene.flat.sobol, 1});
    flat_.transferFunction.pieces = pieces_.data();
    flat_.transferFunction.materials = materials_.data();
    flat_.transferFunction.pieceAt = pieceAt_.data();
    flat_.optics.table = optics_.data();
    flat_.lights = lights_.data();
    if (flat_.lightSums != nullptr) {
        flat_.lightSums = lightSums_.data();
        flat_.lightNodes = lightNodes_.data();
    }
    flat_.clip.planes = planes_.data();
    flat_.sobol = sobol_.data();
}

template <Gpu G>
void GpuScene<G>::sendEnvironment(const PreparedScene& scene) {
    if (!scene.environment)
        return;
    FlatEnvironment& flat = flat_.environment;
    if (environment_ != scene.environment) {
        const std::size_t texels = std::size_t(flat.size.x) * flat.size.y;
        texels_.assign({flat.texels, texels});
        density_.assign({flat.pdf, texels});
        rowSums_.assign({flat.rowSums, std::size_t(flat.size.y) + 1});
        columnSums_.assign({flat.columnSums, (std::size_t(flat.size.x) + 1) * flat.size.y});
        environment_ = scene.environment;
    }
    flat.texels = texels_.data();
    flat.pdf = density_.data();
    flat.rowSums = rowSums_.data();
    flat.columnSums = columnSums_.data();
}

/// Builds the majorants. After an edit of the opacity only the curve's pieces go to the GPU, and a few numbers come
/// back.
template <Gpu G>
Result<void> GpuScene<G>::bound(const PreparedScene& scene) {
    const bool highestHu = scene.flat.optics.model == FlatModel::maximumIntensity;
    const ivec3 coarse = coarseCells(scene.volume->size());
    // Build the bounds on the device, and wait for their summary
    summary_.resize(1);
    summaryHere_.resize(1);
    if (summaryHere_.size() == 1)
        *summaryHere_.data() = {};
    summary_.copyFrom(summaryHere_.data());
    gpu_.launch(BoundFineKernel{ranges_.data(), flat_.transferFunction, scene.tables.highestOpacity(), highestHu,
                                flat_.mask, flat_.parts, scene.volume->size(), coarse * kFinePerCoarse, fine_.data()},
                std::int64_t(fine_.size()), GpuStream::compute);
    gpu_.launch(BoundCoarseKernel{fine_.data(), coarse, coarse_.data(), summary_.data()}, std::int64_t(coarse_.size()),
                GpuStream::compute);
    summary_.copyTo(summaryHere_.data());
    gpu_.awaitAll();
    if (Result<void> done = takeStatus(gpu_); !done) {
        forget();
        return done;
    }
    // Find the box around all occupied cells
    const BoundsSummary& summary = *summaryHere_.data();
    const vec3 volumeLow(-0.5f), volumeHigh = vec3(scene.volume->size()) - 0.5f;
    const ivec3 low(summary.low[0], summary.low[1], summary.low[2]);
    const ivec3 high(summary.high[0], summary.high[1], summary.high[2]);
    const bool nothing = low.x > high.x;
    flat_.majorants = {
        .fine = fine_.data(),
        .coarse = coarse_.data(),
        .fineSize = coarse * kFinePerCoarse,
        .coarseSize = coarse,
        .occupiedLow = highestHu ? volumeLow : glm::max(nothing ? vec3(1e30f) : lowCorner(low), volumeLow),
        .occupiedHigh = highestHu ? volumeHigh : glm::min(nothing ? vec3(-1e30f) : highCorner(high), volumeHigh),
        .dense = mayBeDense(flat_.volume, floatOf(summary.highest))};
    return {};
}

template <Gpu G>
void GpuScene<G>::boundView(const PreparedScene& scene) {
    const ivec2 film = scene.flat.camera.film, blocks = viewBlocks(film);
    const std::size_t count = std::size_t(blocks.x) * blocks.y;
    orderedDepths_.resize(count);
    depths_.resize(count);
    wide_.resize(1);
    wide_.clear();
    wideCells_.resize(WideCells::kRoom);
    gpu_.launch(ClearDepthsKernel{orderedDepths_.data()}, std::int64_t(count), GpuStream::compute);
    gpu_.launch(ProjectCellsKernel{flat_.majorants, ViewProjection(flat_), flat_.clip, film, blocks,
                                   orderedDepths_.data(), wide_.data(), wideCells_.data()},
                std::int64_t(fine_.size()), GpuStream::compute);
    gpu_.launch(SpreadWideCellsKernel{wide_.data(), wideCells_.data(), blocks, orderedDepths_.data()},
                std::int64_t(WideCells::kRoom) * WideCells::kThreads, GpuStream::compute);
    gpu_.launch(ViewDepthsKernel{orderedDepths_.data(), wide_.data(), depths_.data()}, std::int64_t(count),
                GpuStream::compute);
    flat_.viewBounds = {depths_.data(), blocks.x};
}

template <Gpu G>
void GpuScene<G>::forget() {
    pieces_.forget();
    materials_.forget();
    pieceAt_.forget();
    materialOf_.forget();
    curveOf_.forget();
    partPieces_.forget();
    partMaterials_.forget();
    partPieceAt_.forget();
    curves_.forget();
    optics_.forget();
    lights_.forget();
    lightSums_.forget();
    lightNodes_.forget();
    planes_.forget();
    sobol_.forget();
    mask_ = nullptr;
    map_ = nullptr;
    cells_ = nullptr;
    environment_ = nullptr;
}

/// Releases what grows with the volume, the film or an environment image; the tables are small and stay.
template <Gpu G>
Result<void> GpuScene<G>::close() {
    gpu_.awaitAll();
    scene_ = nullptr;
    flat_ = {};
    forget();
    texture_.free();
    weights_.free();
    labels_.free();
    onlyCurve_.free();
    voxels_.free();
    ranges_.free();
    fine_.free();
    coarse_.free();
    texels_.free();
    density_.free();
    rowSums_.free();
    columnSums_.free();
    orderedDepths_.free();
    wide_.free();
    wideCells_.free();
    depths_.free();
    return takeStatus(gpu_);
}

}  // namespace pdr
