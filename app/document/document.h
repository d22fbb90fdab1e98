#pragma once
/// The document of the window: a volume, the user's plan for it, and the history of earlier plans. Only this class
/// increments a scene's revision.

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/open_scan.h"
#include "app/looks/fitted_looks.h"
#include "app/plan/history.h"
#include "render/volume/arriving_volume.h"

namespace pdr::app {

class Document : public QObject {
    Q_OBJECT

  public:
    /// `looks` holds at least one look.
    explicit Document(std::vector<NamedLook> looks);

    /// The looks to choose from, fitted to the volume.
    const FittedLooks& looks() const { return looks_; }
    /// Returns the setup that choosing `look` would lead to.
    ImageSetup setupWith(int look) const;
    /// The volume that is rendered, with or without the table as set up; null without a volume. With the table it is
    /// built anew once nobody holds it any longer.
    std::shared_ptr<const Volume> seen() const { return scan_.seen(setup().table); }
    /// The scan without its table, whatever is shown; null without a volume.
    const std::shared_ptr<const Volume>& scan() const { return scan_.volume(); }
    /// The parts of the body that can be shown or hidden; null without a volume.
    const std::shared_ptr<const segment::BodyParts>& parts() const { return scan_.bodyParts(); }
    /// The parts that a label map or a rule names, as they are shown; null: there are none.
    const std::shared_ptr<const ScanParts>& scanParts() const { return scan_.parts().parts(); }
    /// Where the parts come from that the scene shows.
    const PartSources& shownSources() const { return scan_.parts().shown(); }
    /// The part of the scan's grid that the body fills.
    const VolumeGeometry& bodyBox() const { return scan_.bodyBox(); }
    const Plan& plan() const { return plan_; }
    const ImageSetup& setup() const { return plan_.image; }
    bool hasVolume() const { return scan() != nullptr; }
    /// The volume that is being read, of which slices can be seen already; null: none is.
    const std::shared_ptr<const ArrivingVolume>& arriving() const { return arriving_; }
    /// The grey window that the slices began with.
    const GreyWindow& firstWindow() const { return firstWindow_; }
    /// The scene that is rendered. Without a volume its content is meaningless.
    const Scene& scene() const { return scene_; }
    /// Whether there is a table, or anything else hidden with it, that can be shown or hidden.
    bool hasTable() const { return scan_.hasTable(); }
    /// The index of the look that is shown; -1 if the user has changed it.
    int look() const { return looks_.indexOf(setup()); }
    Display display() const;
    /// Whether the image is shown denoised.
    bool denoised() const { return denoised_; }
    /// The box that cuts begin with: the smallest box along the patient's axes around what is framed; none without a
    /// volume.
    std::optional<ClipBox> uncut() const;
    bool canUndo() const { return history_.canUndo(); }
    bool canRedo() const { return history_.canRedo(); }
    /// Returns the menu's phrase for the next undo, e.g. "Undo turning the view"; "Undo" if there is none.
    Text undoText() const;
    /// Returns the menu's phrase for the next redo; "Redo" if there is none.
    Text redoText() const;
    /// Replaces the plan. `gesture`: what a gesture of the user edits; one gesture (moving, ..., moving, at rest) is
    /// one step to undo. Changes::none: the edit is a step of its own. A gesture that ends where it began makes no new
    /// scene.
    void edit(Plan plan, Changes gesture = Changes::none, bool moving = false);
    /// Replaces the plan by `plan`, without a choice that cannot be shown. If that choice was all that its undo step
    /// changed, the step is removed; no other step to undo.
    void fallBackTo(Plan plan);

  public slots:
    /// Shows the slices of a volume while it is read, through `window` at first. There is no volume yet: nothing can be
    /// rendered or measured. Ends with open() of the same volume once it is complete, or with close().
    void arrive(std::shared_ptr<const pdr::ArrivingVolume> volume, const pdr::GreyWindow& window);
    /// Reports that slices of the arriving volume are on the screen: they stay where they are when it opens.
    void seeArrived();
    /// Opens `volume`, a scan without its table, uncut and seen from the side that firstView() chooses. The look stays
    /// as it is, or becomes the first one that suits the scan if it does not. The previous volume cannot be restored.
    /// `table`: what was hidden. `findings`: what the volume holds, as far as it is known. `hidden`: the voxels of the
    /// table; null if nothing is hidden. `window`: the grey window that the slices begin with. Slices that
    /// were seen while the volume arrived stay as they are.
    void open(std::shared_ptr<const pdr::Volume> volume, const pdr::segment::HiddenTable& table,
              const std::optional<pdr::segment::Findings>& findings = {},
              std::shared_ptr<const pdr::app::HiddenVoxels> hidden = {}, const pdr::GreyWindow& window = {});
    /// Opens a volume without a detected table.
    void open(std::shared_ptr<const pdr::Volume> volume);
    /// Closes the volume and forgets the history.
    void close();
    /// Sets the camera. One gesture is one step to undo.
    void setCamera(const pdr::Camera& camera, bool moving);
    /// Turns to a standard view and fits it, with the projection, field of view and aperture as they are.
    void setView(pdr::StandardView view);
    /// Focuses at `depthMm` in front of the eye, along the view; > 0.
    void setFocus(double depthMm);
    /// Returns to the view that open() sets, with the default lens.
    void resetView();
    /// Sets the radiance of the background; none: the environment, which becomes visible.
    void setBackground(const std::optional<pdr::vec3>& radiance);
    void setTable(pdr::Table table);
    void setModel(pdr::Model model);
    /// Applies look `index` with its model, its cut and the brightness that suits it. One step to undo. The cut of the
    /// previous look is removed.
    void chooseLook(int index);
    /// Replaces the looks to choose from; the image stays as it is. `looks` holds at least one look.
    void setLooks(std::vector<pdr::NamedLook> looks);
    /// Reports the brightness [stops] that suits this volume under a look; choosing the look then sets it. Only the
    /// first report for a look counts. If the look is shown and its brightness is untouched, it is set at once. No step
    /// to undo: it may come during a gesture.
    void suggestBrightness(int look, double stops);
    /// Sets a look that the user has edited. One gesture is one step to undo.
    void setLook(const pdr::Look& look, bool moving = false);
    /// Sets what is cut away. One gesture is one step to undo.
    void setClip(const pdr::Clip& clip, bool moving = false);
    /// Cancels the gesture in progress and restores the plan from before it.
    void giveUpGesture();
    /// Sets which part of the patient is visible. It is a part of the look.
    void setVisible(const pdr::Visible& visible, bool moving = false);
    /// Takes the mask that maskWanted() has requested for `visible`. Null: the scan does not have that part; all of the
    /// patient is shown, as if no part had been chosen.
    void setMask(const pdr::Visible& visible, const std::shared_ptr<const pdr::Mask>& mask);
    /// Reports that the requested mask will not come: the choice returns to what the scene shows. No step to undo.
    void keepVisible();
    /// Sets whether the image shows the CT with less noise. It is a part of the look.
    void setCtDenoised(bool denoised);
    /// Takes what denoisedCtWanted() has requested for `scan`. Slices and measurements never see it.
    void takeDenoisedCt(const std::shared_ptr<const pdr::Volume>& scan,
                        const std::shared_ptr<const pdr::Volume>& denoised);
    /// Reports that the requested volume will not come: the image shows the CT as it is. No step to undo.
    void keepNoise();
    /// Takes the parts from `sources`, which partsWanted() has requested or a plan will have.
    void takeParts(const pdr::app::PartSources& sources, const std::shared_ptr<const pdr::app::ScanParts>& parts);
    /// Replaces the setup of the image. One step to undo.
    void setSetup(const pdr::ImageSetup& setup);
    void setEstimator(pdr::Estimator estimator);
    void setSchedule(const pdr::Schedule& schedule);
    /// Moves the crosshair to a place of the patient (LPS) [mm]; see navigate().
    void moveCrosshair(pdr::dvec3 placeMm);
    /// Moves through the slices, or sets their layout; the image stays as it is. All moves between two other edits are
    /// one step to undo.
    void navigate(const pdr::app::Navigation& navigation);
    /// Sets the brightness [stops against the look's]. It changes the display only, not what is computed. One gesture
    /// is one step to undo.
    void setBrightness(double stops, bool moving = false);
    /// Sets whether the image is shown denoised. It changes the display only; no step to undo.
    void setDenoised(bool denoised);
    /// Sets the size [pixels] of films that begin from now on. The current film stays, with all its samples.
    void setNextFilm(pdr::ivec2 pixels);
    /// Sets the view's size in physical screen pixels, which becomes the film's size. If it differs from the current
    /// film's, the image begins anew. No step to undo.
    void setViewSize(pdr::ivec2 pixels);
    void undo();
    void redo();

  signals:
    /// Emitted while a series closes; hasVolume() is false already, so that edits make no scene. Every holder of the
    /// volume, its table, parts or masks releases them now, since the next series waits for their memory.
    void closing();
    /// Emitted once at the end of each operation that may have changed something, for those who show the document.
    /// `changes`: what has changed; an edit that did not change the plan may still have changed the history.
    void changed(pdr::app::Changes changes);
    /// Emitted when there is a new scene to render, and with the same scene when a gesture ends where it has led.
    /// `moving`: more will follow at once.
    void sceneChanged(const pdr::Scene& scene, bool moving);
    void displayChanged(const pdr::Display& display);
    /// Requests the mask of the parts that `visible` shows. Until setMask() the scene keeps the mask that it has.
    void maskWanted(const std::shared_ptr<const pdr::segment::BodyParts>& parts, const pdr::Visible& visible);
    /// Requests `scan` with less noise. Until takeDenoisedCt() the scene shows it as it is.
    void denoisedCtWanted(const std::shared_ptr<const pdr::Volume>& scan);
    /// Requests the parts from `sources`. Until takeParts() the scene shows those that it has.
    void partsWanted(const pdr::app::PartSources& sources);

  private:
    void closeVolume();
    Navigation firstNavigation(const VolumeGeometry& bodyBox) const;
    void remember(Changes gesture = Changes::none, bool moving = false);
    template <typename Field>
    void setField(Field ImageSetup::*field, const Field& value, Changes gesture = Changes::none, bool moving = false);
    void edit(ImageSetup image, Changes gesture = Changes::none, bool moving = false);
    void comeBackTo(Plan plan);
    void report(const Plan& before, Changes also = Changes::none);
    void showIfOther();
    void show(bool moving);
    void showArrived();
    void fallBackTo(const Visible& visible);
    void fallBackTo(const Look& look);
    void show(Scene scene, bool moving);
    Framed framed() const { return scan_.framed(setup().table); }
    Camera cameraOf(StandardView view, const Camera& lens) const;
    ImageSetup withoutCutOf(int look) const;
    void fitLooksTo(const std::optional<segment::Findings>& findings);

    FittedLooks looks_;
    OpenScan scan_;
    std::shared_ptr<const ArrivingVolume> arriving_;  ///< null once it is open
    bool wasSeen_ = false;                            ///< whether slices of it were on the screen
    GreyWindow firstWindow_;
    Plan plan_;  ///< everything that undo restores
    History history_;
    bool denoised_ = true;
    ivec2 film_ = Scene{}.film;      ///< size of the scene's film [pixels]
    ivec2 nextFilm_ = Scene{}.film;  ///< size of the next film [pixels]
    Scene scene_;                    ///< built from the volume with or without its table, the plan and the film's size
};

}  // namespace pdr::app
