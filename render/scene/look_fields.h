#pragma once
/// The fields that scene files and presets share.

#include "render/scene/json_fields.h"
#include "render/scene/scene.h"
#include "render/scene/transfer_function.h"

namespace pdr {

/// Reads `transferFunction`; ranges are left to TransferFunction::check(). All four throw FieldError.
TransferFunction readTransferFunction(JsonFields& parent);
/// Reads `phase` {`g`} where it is there.
void readPhase(JsonFields& parent, float& phaseG);
/// Reads `surface` {`gradientFactor`} where it is there.
void readSurface(JsonFields& parent, float& gradientFactor);
/// Reads `window` {`lowHu`, `highHu`} where it is there.
void readWindow(JsonFields& parent, HuWindow& window);

}  // namespace pdr
