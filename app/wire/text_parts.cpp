#include "app/wire/text_parts.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <optional>
#include <vector>

namespace pdr::wire {
namespace {

constexpr const char *kNumber = "number", *kSentence = "sentence";

QJsonValue valueOf(const Text& text) {
    switch (text.kind()) {
        case Text::Kind::pattern: {
            QJsonArray array{QString::fromStdString(text.pattern())};
            for (const Text& argument : text.arguments())
                array.append(valueOf(argument));
            return array;
        }
        case Text::Kind::number:
            return QJsonObject{{kNumber, QString::fromStdString(text)}};
        case Text::Kind::sentence:
            return QJsonObject{{kSentence, valueOf(text.arguments().front())}};
        case Text::Kind::words:
            break;
    }
    return QString::fromStdString(text);
}

/// Builds a text from parts of an untrusted peer. A pattern may name an argument many times, and arguments are nested:
/// a text that grows beyond `mostBytes` is rejected, as are parts that have no meaning.
class Reading {
  public:
    explicit Reading(std::size_t mostBytes) : most_(mostBytes) {}

    std::optional<Text> of(const QJsonValue& value) const {
        const std::optional<Text> text = any(value);
        return text && text->size() <= most_ ? text : std::nullopt;
    }

  private:
    std::optional<Text> any(const QJsonValue& value) const {
        if (value.isString())
            return Text(value.toString().toStdString());
        if (value.isArray())
            return pattern(value.toArray());
        const QJsonObject object = value.toObject();
        if (object.value(kNumber).isString())
            return Text::number(object.value(kNumber).toString().toStdString());
        if (!object.contains(kSentence))
            return std::nullopt;
        const std::optional<Text> phrase = of(object.value(kSentence));
        return phrase ? std::optional(Text::sentence(*phrase)) : std::nullopt;
    }

    std::optional<Text> pattern(const QJsonArray& array) const {
        if (!array.at(0).isString())
            return std::nullopt;
        std::vector<Text> arguments;
        for (qsizetype i = 1; i < array.size(); ++i) {
            std::optional<Text> argument = of(array.at(i));
            if (!argument)
                return std::nullopt;
            arguments.push_back(*std::move(argument));
        }
        return Text(array.at(0).toString().toStdString().c_str(), std::move(arguments));
    }

    std::size_t most_;
};

}  // namespace

std::string partsOf(const Text& text) {
    if (text.empty() || (text.kind() != Text::Kind::pattern && text.kind() != Text::Kind::sentence))
        return {};
    const QJsonValue value = valueOf(text);
    const QJsonDocument document = value.isArray() ? QJsonDocument(value.toArray()) : QJsonDocument(value.toObject());
    return document.toJson(QJsonDocument::Compact).toStdString();
}

Text textOf(const std::string& english, const std::string& parts) {
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(parts));
    const QJsonValue value = document.isArray() ? QJsonValue(document.array()) : QJsonValue(document.object());
    const std::optional<Text> text = Reading(english.size()).of(value);
    return text && std::string(*text) == english ? *text : Text(english);
}

}  // namespace pdr::wire
