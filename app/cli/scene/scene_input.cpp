#include "app/cli/scene/scene_input.h"

#include <cmath>
#include <cstdio>
#include <utility>

#include "app/cli/progress_line.h"
#include "app/cli/scene/named_scene.h"
#include "app/looks/fitted_looks.h"
#include "app/looks/looks.h"
#include "app/looks/small_image.h"
#include "app/scan/environment_image.h"
#include "app/scan/scene_volume.h"
#include "render/prepare/flatten.h"
#include "render/prepare/layers_text.h"
#include "render/scene/fit_view.h"
#include "render/scene/not_shown.h"
#include "render/scene/visible_mask.h"
#include "render/smooth/non_local_means.h"
#include "render/volume/coarser.h"
#include "render/volume/value_unit.h"

namespace pdr::app {
namespace {

constexpr ivec2 kFolderFilm{1024, 1024};

/// Reads the scene file, or makes a scene for a scan, and applies the options that do not need the voxels.
Result<SceneFile> readInput(const SceneInput& input) {
    Result<SceneFile> file = namedScene(input.path, input.seriesUid);
    if (!file)
        return file;
    const bool isFile = isSceneFile(input.path);
    file->source.table = input.table.value_or(isFile ? file->source.table : Table::hidden);
    file->scene.film = input.size.value_or(isFile ? file->scene.film : kFolderFilm);
    file->scene.seed = input.seed.value_or(file->scene.seed);
    return file;
}

/// Stores the voxels and the notes about them, and sets the initial camera unless the scene file has one that is to be
/// used.
void take(LoadedScene& work, const SceneInput& input, const FetchedVolume& volume) {
    const Framed& framed = volume.wanted.framed;
    work.uncut = boxAround(framed.box);
    work.series = volume.series;
    work.scene.volume = volume.wanted.volume;
    for (const dicom::Note& note : volume.notes)
        work.notes.push_back(note.text);
    if (const std::string table = segment::tableText(volume.wanted.table); !table.empty())
        work.notes.push_back(table);
    if (input.view || !isSceneFile(input.path))
        work.scene.camera = fittedView(input.view.value_or(firstView(framed.box)), framed,
                                       double(work.scene.film.x) / double(work.scene.film.y), kViewFilled);
}

/// Returns the requested look. Without one, a folder gets the first look that suits the scan, as in the window; null
/// for a scene file, which has its own. Error: one is requested, and the scan is not in HU.
Result<std::optional<NamedLook>> chosenLook(const SceneInput& input, const Volume& volume, const VolumeGeometry& body,
                                            std::vector<std::string>& notes) {
    if (!input.look && isSceneFile(input.path))
        return std::optional<NamedLook>();
    const bool isInHu = unitOf(volume).isHu;
    if (input.look && !isInHu)
        return Error{"looks are drawn in HU, and the values of this scan are none", "--look",
                     "Leave it out: the curve then follows the values of the scan.", ErrorKind::refused};
    auto bundled = input.look ? Result(std::vector{*input.look}) : bundledLooks();
    if (!bundled)
        return bundled.error();
    FittedLooks looks(*std::move(bundled));
    if (isInHu)
        looks.fitTo(segment::findingsOn(volume, body));
    else
        looks.fitToValues(spreadOf(volume));
    const int chosen = looks.suitedOr(0);
    if (const std::string why = looks.whyUnsuited(chosen); !why.empty())
        notes.push_back("The look \"" + looks[chosen].name + "\" is not meant for this scan: " + why + ".");
    return std::optional(looks[chosen]);
}

/// Applies the look, and then the options that override it.
Result<void> dress(LoadedScene& work, const SceneInput& input, const std::optional<NamedLook>& look,
                   const VolumeGeometry& body) {
    if (look) {
        work.display = look->look.display;
        work.scene = withNamedLook(std::move(work.scene), *look, body);
    }
    if (input.exposure)
        work.display.exposure = float(*input.exposure);
    work.display.curve = input.toneCurve.value_or(work.display.curve);
    work.scene.model = input.model.value_or(work.scene.model);
    work.scene.estimator = input.estimator.value_or(work.scene.estimator);
    work.scene.camera.apertureMm = input.apertureMm.value_or(work.scene.camera.apertureMm);
    return work.scene.check();
}

/// Marks the look's name as changed if the scene differs from the look: an image must not bear the name of a look that
/// it does not show.
void nameLook(Scene& scene, const NamedLook& look, const std::vector<PartLook>& looks) {
    const bool otherParts = !looks.empty() || (scene.parts.map && look.look.parts.empty());
    if (scene.model != look.model || scene.visible != look.look.visible || otherParts)
        scene.lookName += kChangedLook;
}

/// Makes the mask that hides tissue. If the scan lacks a part that only the look asks for, adds a note and shows
/// everything.
Result<void> hide(LoadedScene& work, const SceneInput& input, const segment::BodyParts& parts,
                  const Progress& progress) {
    Visible& visible = work.scene.visible;
    if (input.parts)
        visible = {input.parts->shown, input.parts->hidden, visible.peelMm};
    visible.peelMm = input.peelMm.value_or(visible.peelMm);
    const auto mask = visibleMask(parts, visible, parts.volume().geometry(), progress);
    if (!mask && (input.parts || input.peelMm || mask.error().kind != ErrorKind::refused))
        return mask.error();
    if (!mask) {
        visible = {};
        work.notes.push_back("everything is shown: " + mask.error().what);
        return {};
    }
    work.scene.mask = *mask;
    return {};
}

/// Shows parts of the patient as the look and the options say, or with the materials that the scene file names.
Result<void> giveParts(LoadedScene& work, const PartLooks& looks, const std::optional<NamedLook>& look,
                       const PartsSource& ofFile, const Progress& progress) {
    Scene& scene = work.scene;
    const PartStyles styles = look ? look->look.parts : PartStyles();
    if (looks.source.isGiven()) {
        auto shown = withPartLooks(scene, looks, styles, work.series.get(), progress);
        if (!shown)
            return shown.error();
        scene = *std::move(shown);
        if (looks.looks.empty() && scene.parts.curves.empty())
            work.notes.push_back("the parts look as all tissue does: give them a look with --part.");
    } else if (ofFile.isGiven()) {
        auto parts = partsOfFile(ofFile, scene.parts.curves, *scene.volume, work.series.get(), progress);
        if (!parts)
            return parts.error();
        scene.parts = *std::move(parts);
    } else {
        if (!styles.empty())
            work.notes.push_back("The look shows parts of the scan, such as vessels: --find or --labels gives them.");
        return {};
    }
    for (const Text& note : scene.parts.map->notes)
        work.notes.push_back(note);
    return scene.check();
}

/// Sets the exposure so that the tissue lies in the middle of the display range.
Result<void> expose(LoadedScene& work, const segment::BodyParts& parts, const VolumeGeometry& body) {
    Scene coarse = work.scene;
    coarse.volume = coarseCopy(*work.scene.volume);
    coarse.mask = coarseMask(*coarse.volume, parts, coarse.visible, noProgress);
    if (const auto& map = coarse.parts.map)
        coarse.parts.map = std::make_shared<const LabelMap>(coarser(*map, coarse.volume->geometry()));
    const std::unique_ptr<Device> device = makeCpuDevice();
    const auto small = smallImage(std::move(coarse), body, double(work.display.exposure), *device, {});
    if (!small)
        return small.error();
    work.display.exposure *= float(std::exp2(-small->stops));
    return {};
}

/// Makes sharp what `pixel` shows: of several layers the one with the greatest share of the light, with a note.
Result<void> focus(LoadedScene& work, ivec2 pixel) {
    Scene& scene = work.scene;
    if (pixel.x >= scene.film.x || pixel.y >= scene.film.y)
        return Error{"lies outside the image of " + std::to_string(scene.film.x) + " x " +
                         std::to_string(scene.film.y) + " pixels",
                     "--focus", ""};
    const LayersUnder under = layersUnder(*Flattener().prepare(scene), vec2(pixel) + 0.5f);
    const std::string where = std::to_string(pixel.x) + "," + std::to_string(pixel.y);
    const Text text = layersText(under);
    if (under.layers.empty())
        return Error{"there is nothing to focus on under pixel " + where + ": " + text, "--focus",
                     "Take a pixel that shows opaque tissue."};
    scene.camera.focusMm = under.heaviest()->depthMm;
    if (!text.empty())
        work.notes.push_back("focus on pixel " + where + ": " + text);
    return {};
}

}  // namespace

Result<LoadedScene> loadScene(const SceneInput& input, const Progress& progress) {
    // Read the scene file, the voxels and the environment image
    auto file = readInput(input);
    if (!file)
        return file.error();
    auto volume = fetchVolume(file->source, partOf(progress, 0, 0.9));
    if (!volume)
        return volume.error();

    auto environment = fetchEnvironment(*file);
    if (!environment)
        return environment.error();

    // Assemble the scene and choose its look
    LoadedScene work{std::move(file->scene), {}, {}, {input.path, file->source.raw.path, file->environmentImage}};
    work.scene.environment.image = *std::move(environment);
    take(work, input, *volume);
    const VolumeGeometry body = volume->wanted.framed.box;
    volume->wanted = {};  // frees voxels that are not shown
    const auto look = chosenLook(input, *work.scene.volume, body, work.notes);
    if (!look)
        return look.error();
    if (auto ok = dress(work, input, *look, body); !ok)
        return ok.error();
    // Apply what depends on the tissue: mask, exposure, focus
    const segment::BodyParts parts(work.scene.volume);
    if (auto ok = hide(work, input, parts, partOf(progress, 0.9, 0.95)); !ok)
        return ok.error();
    if (auto ok = giveParts(work, input.partLooks, *look, file->parts, partOf(progress, 0.95, 0.97)); !ok)
        return ok.error();
    work.scene.ctDenoised = work.scene.ctDenoised || input.ctDenoised;
    if (auto ok = denoiseCt(work, partOf(progress, 0.97, 1)); !ok)
        return input.ctDenoised ? ok.error().in("--ct-denoised") : ok.error();
    if (const Text hidden = notShown(work.scene); !hidden.empty())
        work.notes.push_back(hidden);
    if (*look)
        nameLook(work.scene, **look, input.partLooks.looks);
    if (input.autoExposure && followsTissue(work.scene.model))
        if (auto ok = expose(work, parts, body); !ok)
            return ok.error();
    if (input.focusAt)
        if (auto ok = focus(work, *input.focusAt); !ok)
            return ok.error();
    return work;
}

Result<LoadedScene> loadSceneShown(const SceneInput& input) {
    ProgressLine line;
    auto loaded = loadScene(input, line.until());
    line.finish();
    if (loaded)
        tellNotes(*loaded);
    return loaded;
}

Result<void> denoiseCt(LoadedScene& work, const Progress& progress) {
    if (!work.scene.ctDenoised)
        return {};
    auto denoised = ctDenoised(*work.scene.volume, progress);
    if (!denoised)
        return denoised.error();
    work.scene.volume = std::make_shared<const Volume>(*std::move(denoised));
    work.notes.emplace_back("the CT is denoised for this image; no value may be read from it");
    return {};
}

void tellNotes(const LoadedScene& loaded) {
    for (const std::string& note : loaded.notes)
        std::fprintf(stderr, "note: %s\n", note.c_str());
}

}  // namespace pdr::app
