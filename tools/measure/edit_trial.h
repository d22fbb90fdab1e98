#pragma once
/// An edit of the look, and how good its images of a few samples are: the old image left as it is, the new samples, the
/// same denoised, and what is shown (render/edit/edited_image.h).

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <numbers>
#include <optional>

#include "render/device/device.h"
#include "render/edit/coarse_edit.h"
#include "render/edit/edited_image.h"
#include "render/film/display/enlarged_film.h"
#include "render/film/display/tone_map.h"
#include "render/scene/look.h"
#include "render/scene/scene.h"
#include "render/session/edited_view.h"
#include "render/session/session.h"
#include "tools/measure/shown_error.h"

namespace pdr {

/// An edit as an option names it: node:30 moves the middle node by 30 HU, lights:3 turns all lamps by 3 degrees about
/// the patient's axis, albedo:0.9 multiplies all colours, curve:20 moves all nodes, opacity:0.9 multiplies all
/// opacities.
inline std::optional<Look> editedLook(Look look, const QString& edit) {
    const QString kind = edit.section(':', 0, 0);
    const double by = edit.section(':', 1).toDouble();
    auto& nodes = look.transferFunction.nodes;
    if (kind == "node")
        nodes[nodes.size() / 2].hu += float(by);
    else if (kind == "curve")
        for (TransferNode& node : nodes)
            node.hu += float(by);
    else if (kind == "opacity")
        for (TransferNode& node : nodes)
            node.opacity = std::min(1.0f, node.opacity * float(by));
    else if (kind == "albedo")
        for (TransferNode& node : nodes)
            node.albedo = glm::min(vec3(1), node.albedo * float(by));
    else if (kind == "lights")
        for (RigPanel& panel : look.rig.panels) {
            const double turn = by * std::numbers::pi / 180, x = panel.from.x, z = panel.from.z;
            panel.from.x = x * std::cos(turn) - z * std::sin(turn);
            panel.from.z = x * std::sin(turn) + z * std::cos(turn);
        }
    else
        return std::nullopt;
    return look;
}

/// A cut as an option names it: cut:10 cuts away what is nearer to the eye than a plane 10 mm before the middle of the
/// view.
inline std::optional<Clip> editedClip(Clip clip, const Camera& camera, const QString& edit) {
    if (edit.section(':', 0, 0) != "cut")
        return std::nullopt;
    const dvec3 toEye = -camera.forward();
    clip.planes.push_back({camera.targetMm + edit.section(':', 1).toDouble() * toEye, toEye});
    return clip;
}

/// A film of a scene, and its first samples.
struct SampledScene {
    std::unique_ptr<Accumulator> live;
    FirstSamples first;

    /// Returns the film with so many samples in every pixel.
    std::shared_ptr<const Film> at(std::uint64_t samples) {
        for (std::uint64_t had = (*live->film())->samplesPerPixel(); had < samples;) {
            const std::uint64_t n = std::min(samples - had, FirstSamples::leftToMark(had));
            if (!live->accumulate(std::uint32_t(n), {}))
                return nullptr;
            had += n;
            first.keep(**live->film());
        }
        return *live->film();
    }
};

/// Returns an empty film of the scene, with the light of its guide `finer` times as fine.
inline SampledScene sampledScene(Device& device, const Scene& scene, int finer = 1) {
    SampledScene sampled{*startFilm(device, scene), {}};
    if (const auto guide = device.guide({finer}, {}))
        sampled.first.keepUnshadowed(*guide);
    return sampled;
}

inline std::shared_ptr<const KeptImage> keptImageOf(SampledScene& scene, std::uint64_t samples) {
    const auto film = scene.at(samples);
    const NoisyFilm noisy = noisyFilm(*film);
    return keptImage(noisy, denoisedHalves(noisy, {}), samples, scene.first);
}

class EditTrial {
  public:
    /// An image of run() for a sheet, and what is printed of it.
    struct Kept {
        QString name;
        QImage image;
        QJsonObject row;
    };

    /// `truth`: the image of the new scene from many other samples, of which `tissue` tells the tissue's pixels.
    EditTrial(QImage truth, std::shared_ptr<const Film> tissue, Display display)
        : truth_(std::move(truth)), tissue_(std::move(tissue)), display_(display) {}

    /// Prints and returns the errors after 1, 4, 16 and 64 samples, from an old film of `samples` samples.
    QJsonArray run(const Scene& before, const Scene& after, std::uint64_t samples, int threads) {
        const std::unique_ptr<Device> device = makeCpuDevice(threads);
        SampledScene then = sampledScene(*device, before);
        const std::shared_ptr<const KeptImage> kept = keptImageOf(then, samples);
        const std::shared_ptr<const Film> oldFilm = then.at(samples);
        old_ = shown(*oldFilm, kept->all, 1);
        then.live.reset();
        for (const int divider : {3, 4, 6, 8})
            runCoarse(before, after, kept, divider, threads);
        kept_ = {{"the image before", old_, add("old image", samples, old_)}};
        SampledScene now = sampledScene(*device, after);
        EditedImage edited(kept);
        for (const std::uint64_t mark : FirstSamples::kMarks) {
            const std::shared_ptr<const Film> film = now.at(mark);
            const NoisyFilm noisy = noisyFilm(*film);
            add("new samples", mark, shown(*film, noisy.all.mean, noisy.unit));
            const QImage denoised = shown(*film, smoothRadiance(noisy), noisy.unit);
            const QJsonObject row = add("denoised", mark, denoised);
            if (mark <= 4)
                kept_.push_back({QString("new samples alone, %1 a pixel").arg(mark), denoised, row});
            std::optional<SmoothingJudgement> judged =
                SmoothingJudgement::of(*film, [&](const NoisyFilm& halves, const std::stop_token& stop) {
                    return edited.halves(halves, denoisedHalves(halves, stop), mark, now.first);
                });
            std::optional<DenoisedError> said;
            if (judged)
                said = judged->overAll(display_);
            add("shown", mark, shown(*film, edited.radiance(*film, now.first, {}), 1), said);
        }
        return rows_;
    }

    /// Returns the image before the edit, and those of 1 and 4 new samples alone, denoised, of the last run().
    const std::vector<Kept>& kept() const { return kept_; }

    /// Adds the images of films of 1 / `divider` of the width: on a guide, and with the change laid on the old image.
    void runCoarse(Scene before, Scene after, const std::shared_ptr<const KeptImage>& kept, int divider, int threads) {
        constexpr int kSamples = 4;
        const int finer = std::min(divider, 4);
        const std::unique_ptr<Device> device = makeCpuDevice(threads);
        const ivec2 size = before.film / divider;
        before.film = after.film = size;
        before.seed = after.seed = before.seed + 99'000'099;
        SampledScene then = sampledScene(*device, before, EditedView::kCoarseFiner);
        (void)then.at(kSamples);
        SampledScene now = sampledScene(*device, after, EditedView::kCoarseFiner);
        const std::shared_ptr<const Film> film = now.at(kSamples);
        const QByteArray way = QByteArray::number(size.x) + " pixels, ";
        const auto add = [&](const char* kind, const QImage& image) {
            this->add(way + kind, kSamples,
                      image.scaled(truth_.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
        };
        if (const auto guide = device->guide({finer}, {})) {
            const EnlargedFilm guided = EnlargedFilm::onGuide(film, *guide);
            add("guided", drawn(guided.image(display_).rgba, guided.size()));
        }
        for (const std::uint64_t mark : {1, 4})
            add(mark == 1 ? "laid 1" : "laid",
                shown(*film, CoarseEdit(kept, size, then.first).radiance(now.first, mark), 1));
    }

    /// Prints and returns the errors of the window's image after so many seconds; `frame`: null if there was none.
    QJsonObject inWindow(double seconds, const QImage& image, const Frame* frame) const {
        if (frame == nullptr) {
            std::printf("window, %g s: no image yet\n", seconds);
            return {{"image", "window"}, {"seconds", seconds}};
        }
        const int levels = levelsOff(image, truth_, *tissue_);
        const double change = changeError(image, old_, truth_), said = shownOf(*frame).status.displayError;
        std::printf(
            "window, %g s: %llu samples, %d x %d  95 %% of the tissue within %3d levels  change off by %.2f"
            "  said: %.1f\n",
            seconds, (unsigned long long)frame->status.samplesPerPixel, frame->size.x, frame->size.y, levels, change,
            said);
        return {{"image", "window"},
                {"seconds", seconds},
                {"samples", double(frame->status.samplesPerPixel)},
                {"width", frame->size.x},
                {"levels", levels},
                {"change", change},
                {"said", std::isfinite(said) ? said : -1}};
    }

  private:
    QImage shown(const Film& film, const denoise::Colours& radiance, double unit) const {
        return drawn(denoisedImageOf(film, radiance, unit, display_).rgba, radiance[0].size());
    }
    static QImage drawn(const std::vector<std::uint8_t>& rgba, ivec2 size) {
        return QImage(rgba.data(), size.x, size.y, 4 * size.x, QImage::Format_RGBA8888)
            .convertToFormat(QImage::Format_RGB32);
    }
    QJsonObject add(const char* kind, std::uint64_t samples, const QImage& image,
                    const std::optional<DenoisedError>& said = std::nullopt) {
        const int levels = levelsOff(image, truth_, *tissue_);
        const double change = changeError(image, old_, truth_);
        std::printf("%-20s %4llu samples  95 %% of the tissue within %3d levels  change off by %.2f", kind,
                    (unsigned long long)samples, levels, change);
        std::printf(said ? "  said: %.1f, at most %.1f\n" : "\n", said ? said->levels : 0,
                    said ? said->levelsAtMost : 0);
        QJsonObject row{{"image", kind}, {"samples", double(samples)}, {"levels", levels}, {"change", change}};
        if (said)
            row["said"] = said->levelsAtMost;
        rows_.append(row);
        return row;
    }

    QImage truth_;
    std::shared_ptr<const Film> tissue_;
    Display display_;
    QImage old_;
    QJsonArray rows_;
    std::vector<Kept> kept_;
};

}  // namespace pdr
