#pragma once
/// References to the desktop's parts, for the functions that make them work together.

#include "app/desktop/battery_rest.h"
#include "app/desktop/nodes_job.h"
#include "app/desktop/render_bridge.h"
#include "app/desktop/settings.h"
#include "app/document/cut_edits.h"
#include "app/document/document.h"
#include "app/document/light_edits.h"
#include "app/document/tissue_edits.h"
#include "app/jobs/import_job.h"
#include "app/jobs/look_pictures.h"
#include "app/jobs/mask_job.h"
#include "app/jobs/model_trial.h"
#include "app/jobs/picture_job.h"
#include "app/jobs/series_pictures.h"
#include "app/jobs/sky_job.h"
#include "app/jobs/tissue_study.h"
#include "app/looks/own_looks.h"
#include "ui/window/main_window.h"

namespace pdr::app {

/// Messages that have been shown for the open scan and are not repeated.
struct SaidOnce {
    bool skin = false;
};

/// References to the desktop's parts. Their owner keeps all of them alive together.
struct DesktopParts {
    ImportJob& import;
    Document& document;
    RenderBridge& bridge;
    ui::MainWindow& window;
    Settings& settings;
    TissueStudy& study;
    TissueEdits& tissue;
    CutEdits& cut;
    LightEdits& light;
    ModelTrial& modelTrial;
    PictureJob& picture;
    MaskJob& masks;
    SkyJob& sky;
    LookPictures& looks;
    OwnLooks& ownLooks;
    NodesJob& nodes;
    SaidOnce& said;
    SeriesPictures& seriesPictures;
    BatteryRest& battery;
};

}  // namespace pdr::app
