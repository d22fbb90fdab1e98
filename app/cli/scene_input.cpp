#include "app/cli/scene_input.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/cli/progress_line.h"
#include "app/environment_picture.h"
#include "app/looks.h"
#include "app/scene_volume.h"
#include "render/base/file_ending.h"
#include "render/device/device.h"
#include "render/film/exposure.h"
#include "render/prepare/flatten.h"
#include "render/prepare/focus.h"
#include "render/scene/fit_view.h"
#include "render/scene/visible_mask.h"

namespace pdr::app {
namespace {

constexpr ivec2 kFolderFilm{1024, 1024};
constexpr double kFilled = 0.95;  ///< fraction of the picture
constexpr int kTrialPixels = 96;  ///< along the longer edge of a picture that tells the exposure
constexpr std::uint32_t kTrialSamples = 16;

bool isFile(const SceneInput& input) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(input.path, ignored);
}

/// What the input says, before the voxels are there.
Result<SceneFile> readInput(const SceneInput& input) {
    SceneFile file;
    if (isFile(input) && fileEnding(input.path) != ".json")
        return Error{"this is a file, but neither a folder nor a scene file (.json)", input.path.string(),
                     "Give the folder that holds the DICOM files."};
    if (isFile(input)) {
        auto read = readSceneFile(input.path);
        if (!read)
            return read.error();
        file = *std::move(read);
    } else {
        file.source.dicomFolder = input.path;
        file.source.table = Table::hidden;
        file.scene.film = kFolderFilm;
    }
    if (!input.seriesUid.empty() && file.source.dicomFolder.empty())
        return Error{"--series chooses among the series of a DICOM folder, this scene has a raw file",
                     input.path.string(), "Leave it out."};
    if (!input.seriesUid.empty())
        file.source.seriesUid = input.seriesUid;
    file.source.table = input.table.value_or(file.source.table);
    file.scene.film = input.size.value_or(file.scene.film);
    file.scene.seed = input.seed.value_or(file.scene.seed);
    return file;
}

/// The look that was asked for; a folder, which has none of its own, gets the first that makes sense of it.
Result<std::optional<NamedLook>> chosenLook(const SceneInput& input, const segment::Findings& findings) {
    if (input.look || isFile(input))
        return input.look;
    auto looks = bundledLooks();
    if (!looks)
        return looks.error();
    const auto suits = [&](const NamedLook& look) { return whyUnsuited(look, findings).empty(); };
    const auto first = std::ranges::find_if(*looks, suits);
    return std::optional(first == looks->end() ? looks->front() : *first);
}

/// Takes what the look says, for the blood of this scan and through this body.
Result<void> dress(LoadedScene& work, const SceneInput& input, const WantedVolume& wanted) {
    const segment::Findings findings = segment::findingsOn(*wanted.volume, wanted.framed.box);
    auto chosen = chosenLook(input, findings);
    if (!chosen)
        return chosen.error();
    if (!*chosen)
        return {};
    const NamedLook look = findings.blood ? fittedTo(**std::move(chosen), *findings.blood) : **std::move(chosen);
    if (const std::string why = whyUnsuited(look, findings); !why.empty())
        work.notes.push_back("The look \"" + look.name + "\" is not meant for this scan: " + why + ".");
    work.display = look.look.display;
    work.scene = withNamedLook(std::move(work.scene), look);
    if (look.cut && work.scene.clip.empty())
        work.scene.clip.planes = {planeOf(*look.cut, wanted.framed.box)};
    return {};
}

/// Hides what is not to be seen. What only the look wants, of a scan that does not have it, is told and left out.
Result<void> hide(LoadedScene& work, const SceneInput& input, const Progress& progress) {
    Visible& visible = work.scene.visible;
    visible.part = input.part.value_or(visible.part);
    visible.peelMm = input.peelMm.value_or(visible.peelMm);
    const Volume& volume = *work.scene.volume;
    const auto mask = visibleMask(segment::BodyParts(work.scene.volume), visible, volume.geometry(), progress);
    if (!mask && (input.part || input.peelMm || mask.error().kind != ErrorKind::refused))
        return mask.error();
    if (!mask) {
        visible = {};
        work.notes.push_back("everything is shown: " + mask.error().what);
        return {};
    }
    work.scene.mask = *mask;
    if (*mask)
        work.notes.push_back((*mask)->hidden());
    return {};
}

/// Brings the tissue into the middle of the display.
Result<void> expose(LoadedScene& work) {
    Scene small = work.scene;
    small.film = glm::max(ivec2(1), small.film * kTrialPixels / std::max(small.film.x, small.film.y));
    const std::unique_ptr<Device> device = makeCpuDevice();
    const auto film = startFilm(*device, small);
    if (!film)
        return film.error();
    if (auto ok = (*film)->accumulate(kTrialSamples, {}); !ok)
        return ok;
    const auto known = (*film)->film();
    if (!known)
        return known.error();
    work.display.exposure *= float(std::exp2(-stopsFor(**known, double(work.display.exposure))));
    return {};
}

Result<void> focus(Scene& scene, ivec2 pixel) {
    if (pixel.x >= scene.film.x || pixel.y >= scene.film.y)
        return Error{"lies outside the picture of " + std::to_string(scene.film.x) + " x " +
                         std::to_string(scene.film.y) + " pixels",
                     "--focus", ""};
    const auto depth = depthUnder(*Flattener().prepare(scene), pixel);
    if (!depth)
        return Error{
            "there is nothing to focus on under pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y),
            "--focus", "Take a pixel that shows opaque tissue."};
    scene.camera.focusMm = *depth;
    return {};
}

}  // namespace

Result<LoadedScene> loadScene(const SceneInput& input, const Progress& progress) {
    auto file = readInput(input);
    if (!file)
        return file.error();
    auto volume = fetchVolume(file->source, partOf(progress, 0, 0.9));
    if (!volume)
        return volume.error();

    auto environment = fetchEnvironment(*file);
    if (!environment)
        return environment.error();

    LoadedScene work{std::move(file->scene), {}, {}, {input.path, file->source.raw.path, file->environmentImage}};
    const WantedVolume& wanted = volume->wanted;
    work.uncut = boxAround(wanted.framed.box);
    work.series = volume->series;
    work.scene.volume = wanted.volume;
    for (const dicom::Note& note : volume->notes)
        work.notes.push_back(note.text);
    if (!wanted.remark.empty())
        work.notes.push_back(wanted.remark);
    work.scene.environment.image = *std::move(environment);
    if (input.view || !isFile(input))
        work.scene.camera = fittedView(input.view.value_or(firstView(wanted.framed.box)), wanted.framed,
                                       double(work.scene.film.x) / double(work.scene.film.y), kFilled);
    if (auto ok = dress(work, input, wanted); !ok)
        return ok.error();
    if (input.exposure)
        work.display.exposure = float(*input.exposure);
    work.scene.model = input.model.value_or(work.scene.model);
    work.scene.estimator = input.estimator.value_or(work.scene.estimator);
    work.scene.camera.apertureMm = input.apertureMm.value_or(work.scene.camera.apertureMm);
    if (auto ok = work.scene.check(); !ok)
        return ok.error();
    if (auto ok = hide(work, input, partOf(progress, 0.9, 1)); !ok)
        return ok.error();
    if (input.autoExposure && followsTissue(work.scene.model))
        if (auto ok = expose(work); !ok)
            return ok.error();
    if (input.focusAt)
        if (auto ok = focus(work.scene, *input.focusAt); !ok)
            return ok.error();
    return work;
}

Result<LoadedScene> loadSceneShown(const SceneInput& input) {
    ProgressLine line;
    auto loaded = loadScene(input, [&](double fraction, std::string_view step) {
        line.show(fraction, step);
        return true;
    });
    line.finish();
    if (loaded)
        tellNotes(*loaded);
    return loaded;
}

void tellNotes(const LoadedScene& loaded) {
    for (const std::string& note : loaded.notes)
        std::fprintf(stderr, "note: %s\n", note.c_str());
}

}  // namespace pdr::app
