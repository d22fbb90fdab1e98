#pragma once
/// What is shown and how: a volume, what the user has set up of its picture, and the way back to earlier setups. The
/// one place where a scene's revision grows.

#include <QObject>
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "app/document/step_name.h"
#include "app/looks/fitted_looks.h"
#include "app/plan/setup_history.h"
#include "app/scan/hidden_voxels.h"
#include "render/scene/fit_view.h"
#include "render/segment/body_parts.h"
#include "render/segment/hidden_table.h"

namespace pdr::app {

class Document : public QObject {
    Q_OBJECT

  public:
    /// `looks` holds at least one.
    explicit Document(std::vector<NamedLook> looks);

    /// What there is to choose from.
    const FittedLooks& looks() const { return looks_; }
    /// What choosing a look would set up.
    PictureSetup setupWith(int look) const;
    /// What is rendered of the scan under any look. With its table it is made anew where nobody holds it any more.
    std::shared_ptr<const Volume> seen() const;
    /// The parts of the patient to tell apart; null without a volume.
    const std::shared_ptr<const segment::BodyParts>& parts() const { return parts_; }
    /// The part of the scan's grid that the body fills.
    const VolumeGeometry& bodyBox() const { return table_.bodyBox; }
    const PictureSetup& setup() const { return setup_; }
    bool hasVolume() const { return volume_ != nullptr; }
    /// What is rendered; of no volume it holds nothing that counts.
    const Scene& scene() const { return scene_; }
    /// Whether there is a table, or what else is hidden with it, to show or hide.
    bool hasTable() const { return hidden_ != nullptr; }
    /// The look that is shown; -1: the user has changed it.
    int look() const { return looks_.indexOf(setup_); }
    Display display() const;
    /// Whether the picture is shown without its noise.
    bool smoothed() const { return smoothed_; }
    /// What there is to cut: the smallest box along the patient's axes around what is framed; nothing without a volume.
    std::optional<ClipBox> uncut() const;
    bool canUndo() const { return history_.canUndo(); }
    bool canRedo() const { return history_.canRedo(); }
    /// What the next step back brought, or the next one forth will bring; nothing where there is none.
    Change undoable() const { return canUndo() ? changeOf(history_.previous(), setup_) : Change::nothing; }
    Change redoable() const { return canRedo() ? changeOf(setup_, history_.next()) : Change::nothing; }

  public slots:
    /// Shows `volume`, a scan without what is known to be its table, from the side that a scan is seen from first,
    /// uncut, with the look as it is, or where that makes no sense of it, the first that does. There is no way back to
    /// the volume before. `findings`: what the volume holds, as far as it is known. `hidden`: its table; null: none.
    void open(std::shared_ptr<const pdr::Volume> volume, const pdr::segment::HiddenTable& table,
              const std::optional<pdr::segment::Findings>& findings = {},
              std::shared_ptr<const pdr::app::HiddenVoxels> hidden = {});
    /// The same of one that nothing is hidden of.
    void open(std::shared_ptr<const pdr::Volume> volume);
    /// Shows nothing.
    void close();
    /// One gesture of the user (moving, ..., moving, at rest) is one step to undo. One that ends where it began makes
    /// no other scene.
    void setCamera(const pdr::Camera& camera, bool moving);
    /// Through the lens as it is.
    void setView(pdr::StandardView view);
    /// Makes what lies `depthMm` in front of the eye, along the view, sharp; > 0.
    void setFocus(double depthMm);
    /// As the volume was seen first, through the lens it was seen with first.
    void resetView();
    /// What stands behind the volume; none: what lights it from all around.
    void setBackground(const std::optional<pdr::vec3>& radiance);
    void setTable(pdr::Table table);
    void setModel(pdr::Model model);
    /// With its model and its cut, at its own brightness: one step to undo. The cut of the look before goes.
    void chooseLook(int index);
    /// Others to choose from; what is shown stays. `looks` holds at least one.
    void setLooks(std::vector<pdr::NamedLook> looks);
    /// The brightness that suits this volume under a look, which it gets when it is chosen. The first one counts; where
    /// the look is shown and its brightness untouched it is set at once. No step to undo: it may come amid a gesture.
    void suggestBrightness(int look, double stops);
    /// The user's own; one gesture is one step to undo, as well.
    void setLook(const pdr::Look& look, bool moving = false);
    /// One gesture is one step to undo, as well.
    void setClip(const pdr::Clip& clip, bool moving = false);
    /// As if the gesture in progress had not been.
    void giveUpGesture();
    /// Which part of the patient is seen: a part of the look.
    void setVisible(const pdr::Visible& visible, bool moving = false);
    /// The mask that was wanted of it; null: the scan does not have that part, and all of it is shown, as if nothing
    /// else had been chosen.
    void setMask(const pdr::Visible& visible, const std::shared_ptr<const pdr::Mask>& mask);
    /// No mask will come: what is seen stays chosen. No step to undo.
    void keepVisible();
    /// All of it at once: one step to undo.
    void setSetup(const pdr::PictureSetup& setup);
    void setEstimator(pdr::Estimator estimator);
    void setSchedule(const pdr::Schedule& schedule);
    /// Only what is shown changes, not what is computed. A step to undo of its own, one for each gesture as well.
    void setBrightness(double stops, bool moving = false);
    /// Only for the eye; no step to undo.
    void setSmoothed(bool smoothed);
    /// Pixels of the films that begin from now on; the one that is there stays, with all its samples.
    void setNextFilm(pdr::ivec2 pixels);
    /// The view's size in the screen's own pixels, of which the film has as many; no step to undo. The image begins
    /// anew where that is another size.
    void setViewSize(pdr::ivec2 pixels);
    void undo();
    void redo();

  signals:
    /// Before the volume goes: who holds it, its table, parts or masks, lets go of them now, since the next series
    /// waits for their memory.
    void closing();
    /// There are other looks to choose from, or the same for another volume.
    void looksChanged();
    /// There is another scene to render. `moving`: more will follow at once.
    void sceneChanged(const pdr::Scene& scene, bool moving);
    void displayChanged(const pdr::Display& display);
    /// What is to be seen of the volume with these parts, which is not known yet. Until setMask() the scene shows what
    /// it showed.
    void maskWanted(const std::shared_ptr<const pdr::segment::BodyParts>& parts, const pdr::Visible& visible);

  private:
    /// A choice and its mask.
    struct PartMask {
        Visible visible;
        std::shared_ptr<const Mask> mask;
    };
    /// Masks that are kept for undo.
    static constexpr std::size_t kMasks = 4;

    void remember(Gesture gesture = Gesture::none, bool moving = false);
    template <typename Field>
    void setField(Field PictureSetup::*field, const Field& value, Gesture gesture = Gesture::none, bool moving = false);
    void edit(PictureSetup setup, Gesture gesture = Gesture::none, bool moving = false);
    void comeBackTo(PictureSetup setup);
    void show(bool moving);
    void fallBackTo(const Visible& visible);
    Scene made();
    void show(Scene scene, bool moving);
    Framed framed() const;
    Camera cameraOf(StandardView view, const Camera& lens) const;
    PictureSetup withoutCutOf(int look) const;
    void fitLooksTo(const std::optional<segment::Findings>& findings);

    FittedLooks looks_;
    std::shared_ptr<const Volume> volume_;             ///< without its table
    segment::HiddenTable table_;                       ///< of it
    std::shared_ptr<const HiddenVoxels> hidden_;       ///< the table's; null: there is none
    mutable std::weak_ptr<const Volume> withTable_;    ///< the scan as it was read, while somebody holds it
    std::shared_ptr<const segment::BodyParts> parts_;  ///< of it, table or not
    PictureSetup setup_;                               ///< all that undo brings back
    SetupHistory history_;
    std::deque<PartMask> masks_;  ///< of the volume, the newest last
    PartMask shown_;              ///< what the scene shows
    bool smoothed_ = true;
    ivec2 film_ = Scene{}.film;      ///< of the scene
    ivec2 nextFilm_ = Scene{}.film;  ///< of the next one
    Scene scene_;                    ///< of the volume, with or without its table, setup and film
};

}  // namespace pdr::app
