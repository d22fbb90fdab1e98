#include "render/scene/look_fields.h"

namespace pdr {
namespace {

TransferNode readNode(JsonFields& fields) {
    TransferNode node;
    fields.required("hu", node.hu);
    fields.required("opacity", node.opacity);
    fields.optional("albedo", node.albedo);
    fields.optional("emission", node.emission);
    fields.optional("specular", node.specular);
    fields.optional("roughness", node.roughness);
    fields.finish();
    return node;
}

}  // namespace

TransferFunction readTransferFunction(JsonFields& parent) {
    JsonFields fields = parent.object("transferFunction");
    TransferFunction transfer;
    fields.required("extinctionPerMm", transfer.extinctionPerMm);
    for (JsonFields& node : fields.objects("nodes"))
        transfer.nodes.push_back(readNode(node));
    fields.finish();
    return transfer;
}

void readPhase(JsonFields& parent, float& phaseG) {
    if (!parent.has("phase"))
        return;
    JsonFields fields = parent.object("phase");
    fields.optional("g", phaseG);
    fields.finish();
}

void readSurface(JsonFields& parent, float& gradientFactor) {
    if (!parent.has("surface"))
        return;
    JsonFields fields = parent.object("surface");
    fields.optional("gradientFactor", gradientFactor);
    fields.finish();
}

void readWindow(JsonFields& parent, HuWindow& window) {
    if (!parent.has("window"))
        return;
    JsonFields fields = parent.object("window");
    fields.required("lowHu", window.lowHu);
    fields.required("highHu", window.highHu);
    fields.finish();
}

}  // namespace pdr
