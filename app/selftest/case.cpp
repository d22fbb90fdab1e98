#include "app/selftest/case.h"

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "app/selftest/data.h"

namespace pdr::selftest {

namespace {

using Json = nlohmann::json;

/// Reader of the fields of one JSON object. done() throws if the object has fields that were not asked for.
class Fields {
  public:
    explicit Fields(const Json& object) : object_(object) {
        if (!object.is_object())
            throw std::runtime_error("an object in braces is missing");
    }

    template <class Value>
    void optional(const char* name, Value& value) {
        asked_.insert(name);
        if (object_.contains(name))
            value = object_.at(name).get<Value>();
    }
    template <class Value>
    void required(const char* name, Value& value) {
        if (!object_.contains(name))
            throw std::runtime_error(std::string("\"") + name + "\" is missing");
        optional(name, value);
    }
    void done() const {
        for (const auto& [name, value] : object_.items())
            if (!asked_.contains(name))
                throw std::runtime_error("unknown field \"" + name + "\"");
    }

  private:
    const Json& object_;
    std::set<std::string> asked_;
};

template <class Value>
Value worded(const std::map<std::string, Value>& words, const std::string& word) {
    const auto found = words.find(word);
    if (found == words.end())
        throw std::runtime_error("unknown word \"" + word + "\"");
    return found->second;
}

CaseScene::Shape shapeOf(const std::string& word) {
    using Shape = CaseScene::Shape;
    return worded<Shape>({{"slab", Shape::slab},
                          {"sphere", Shape::sphere},
                          {"ramp", Shape::ramp},
                          {"surface", Shape::surface},
                          {"slit", Shape::slit}},
                         word);
}

CaseScene::Lamp lampOf(const std::string& word) {
    using Lamp = CaseScene::Lamp;
    return worded<Lamp>({{"beam", Lamp::beam}, {"sphere", Lamp::sphere}, {"rectangle", Lamp::rectangle}}, word);
}

CaseScene::Room roomOf(const std::string& word) {
    using Room = CaseScene::Room;
    return worded<Room>({{"even", Room::even}, {"sky", Room::sky}, {"gradient", Room::gradient}}, word);
}

Quantity quantityOf(const std::string& word) {
    return worded<Quantity>({{"radiance", Quantity::radiance},
                             {"reflectanceFactor", Quantity::reflectanceFactor},
                             {"discTransmittance", Quantity::discTransmittance},
                             {"escapeProbability", Quantity::escapeProbability},
                             {"freeFlights", Quantity::freeFlights},
                             {"meanCosine", Quantity::meanCosine},
                             {"meanSquaredCosine", Quantity::meanSquaredCosine}},
                            word);
}

CaseScene sceneOf(const Json& json) {
    CaseScene scene;
    Fields fields(json);
    std::string shape = "slab", scattering = "single", lamp = "beam", room = "even";
    fields.optional("shape", shape);
    fields.optional("depth", scene.depth);
    fields.optional("extinctionPerMm", scene.extinctionPerMm);
    fields.optional("endRatio", scene.endRatio);
    fields.optional("albedo", scene.albedo);
    fields.optional("g", scene.g);
    fields.optional("emission", scene.emission);
    fields.optional("gradientFactor", scene.gradientFactor);
    fields.optional("specular", scene.specular);
    fields.optional("roughness", scene.roughness);
    fields.optional("blur", scene.blur);
    fields.optional("scattering", scattering);
    fields.optional("bed", scene.bed);
    if (double beam = 0; json.contains("beam")) {
        fields.optional("beam", beam);
        scene.beam = beam;
    }
    fields.optional("lamp", lamp);
    fields.optional("room", scene.room);
    fields.optional("roomKind", room);
    fields.optional("view", scene.view);
    fields.optional("inside", scene.inside);
    fields.done();
    scene.shape = shapeOf(shape);
    scene.lamp = lampOf(lamp);
    scene.roomKind = roomOf(room);
    scene.multiple = worded<bool>({{"single", false}, {"multiple", true}}, scattering);
    return scene;
}

Sharpness sharpnessOf(const Json& json) {
    Sharpness sharpness;
    double samples = 0;
    Fields fields(json);
    fields.required("samples", samples);
    fields.required("detects", sharpness.detects);
    fields.done();
    sharpness.samples = std::uint64_t(samples);
    return sharpness;
}

Case caseOf(const Json& json) {
    Case result;
    std::string quantity = "radiance";
    Json scene = Json::object(), quick, full;
    Fields fields(json);
    fields.required("name", result.name);
    fields.required("source", result.source);
    fields.required("expected", result.expected);
    fields.optional("geometryBias", result.geometryBias);
    fields.optional("quantity", quantity);
    fields.optional("scene", scene);
    fields.required("quick", quick);
    fields.required("full", full);
    fields.done();
    result.quantity = quantityOf(quantity);
    result.scene = sceneOf(scene);
    result.quick = sharpnessOf(quick);
    result.full = sharpnessOf(full);
    return result;
}

}  // namespace

Result<Family> readFamily(std::string_view text, const std::string& where) {
    Family family;
    std::string at = where;
    try {
        Json common = Json::object(), cases;
        const Json json = Json::parse(text);
        Fields fields(json);
        fields.required("family", family.name);
        fields.required("note", family.note);
        fields.optional("common", common);
        fields.required("cases", cases);
        fields.done();
        for (const Json& one : cases) {
            at = where + ", " + one.value("name", "a case without a name");
            Json whole = common;  // the fields that all cases share, overridden by those of this case
            whole.merge_patch(one);
            family.cases.push_back(caseOf(whole));
        }
    } catch (const std::exception& problem) {
        return Error{problem.what(), at, ""};
    }
    return family;
}

Result<std::vector<Family>> shippedFamilies() {
    std::vector<Family> families;
    for (const ReferenceFile& file : referenceFiles()) {
        Result<Family> family = readFamily(file.json, file.name);
        if (!family)
            return family.error();
        families.push_back(std::move(*family));
    }
    return families;
}

}  // namespace pdr::selftest
