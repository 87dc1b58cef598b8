// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame/language.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QXmlStreamReader>
#include <algorithm>
#include <optional>

/// Outside of any namespace, as the macro wants it: the texts lie in a static library.
static void init_translations() { Q_INIT_RESOURCE(translations); }

namespace handsight::app {
namespace {

constexpr const char* core = "core";  // the context of the core's sentences

/// One <message>: its source and the forms of its translation; nothing where it has none.
struct Message {
  QString source;
  QStringList translated;
};

std::optional<Message> read_message(QXmlStreamReader& xml) {
  QString source;
  QStringList translated;
  while (xml.readNextStartElement()) {
    if (xml.name() == QLatin1String("source")) {
      source = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      QString text;
      while (xml.readNext() != QXmlStreamReader::EndElement && !xml.atEnd()) {
        if (xml.isCharacters()) text += xml.text();
        if (xml.isStartElement()) translated << xml.readElementText();  // <numerusform>
      }
      if (translated.isEmpty()) translated << text;
    } else {
      xml.skipCurrentElement();
    }
  }
  if (source.isEmpty() || translated.isEmpty() || translated.front().isEmpty()) return std::nullopt;
  return Message{source, translated};
}

const QRegularExpression& place_in_text() {
  static const QRegularExpression place("%\\d");
  return place;
}

}  // namespace

Translation::Translation(const QString& language) {
  static const bool is_ready = (init_translations(), true);
  QFile file(QString(":/translations/%1.ts").arg(language));
  if (!is_ready || !file.open(QIODevice::ReadOnly)) return;
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() != QLatin1String("message")) continue;
    const auto message = read_message(xml);
    if (!message) continue;
    sources_[context] << message->source;
    forms_[message->source] = message->translated;
    if (context == QLatin1String(core) && message->source.contains(place_in_text()))
      add_phrase(message->source, message->translated.front());
  }
  std::stable_sort(phrases_.begin(), phrases_.end(),
                   [](const Phrase& a, const Phrase& b) { return a.form.pattern().size() > b.form.pattern().size(); });
}

void Translation::add_phrase(const QString& source, const QString& translated) {
  Phrase phrase{.translated = translated};
  QString form;
  qsizetype end = 0;
  for (auto i = place_in_text().globalMatch(source); i.hasNext();) {
    const auto place = i.next();
    if (phrase.places.isEmpty()) phrase.begin = source.left(place.capturedStart());
    form += QRegularExpression::escape(source.mid(end, place.capturedStart() - end)) + "(.+?)";
    phrase.places << place.captured();
    end = place.capturedEnd();
  }
  phrase.form.setPattern(QRegularExpression::anchoredPattern(form + QRegularExpression::escape(source.mid(end))));
  phrases_.push_back(std::move(phrase));
}

QString Translation::of_core(const QString& source) const {
  const auto whole = forms_.find(source);
  return whole == forms_.end() ? phrase(source) : whole->front();
}

/// Empty: none has that form.
QString Translation::phrase(const QString& source) const {
  for (const Phrase& p : phrases_) {
    if (!source.startsWith(p.begin)) continue;
    const auto match = p.form.match(source);
    if (!match.hasMatch()) continue;
    QString text;
    for (qsizetype at = 0; at < p.translated.size(); ++at) {
      const qsizetype place = p.places.indexOf(p.translated.mid(at, 2));
      if (place < 0) {
        text += p.translated[at];
        continue;
      }
      const QString put_in = match.captured(static_cast<int>(place) + 1);
      const QString known = of_core(put_in);
      text += known.isEmpty() ? put_in : known;
      ++at;
    }
    return text;
  }
  return {};
}

QString Translation::translate(const char* context, const char* source, const char*, int n) const {
  const QString text = QString::fromUtf8(source);
  const auto found = forms_.find(text);
  if (found == forms_.end()) return qstrcmp(context, core) == 0 ? phrase(text) : QString();
  return n >= 0 && n != 1 ? found->back() : found->front();
}

QStringList languages() { return {"de"}; }

void speak(QCoreApplication& application, const QString& language) {
  const QString wanted = language.isEmpty() ? QLocale::system().name().section('_', 0, 0) : language;
  if (!languages().contains(wanted)) return;
  application.installTranslator(new Translation(wanted));
}

}  // namespace handsight::app
