// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/language.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QXmlStreamReader>
#include <algorithm>
#include <optional>

#include "widgets/base/number_text.h"

/// Outside of any namespace, as the macro wants it: the texts lie in a static library.
static void init_translations() { Q_INIT_RESOURCE(translations); }

namespace handsight::app {
namespace {

// The contexts of the core's sentences.
constexpr const char* core = "core";
constexpr const char* errors = "errors";
constexpr const char* system = "system";

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
    if (!message->source.contains(place_in_text())) continue;
    if (context == QLatin1String(core)) core_.push_back(phrase_of(message->source, message->translated.front()));
    if (context == QLatin1String(errors)) errors_.push_back(phrase_of(message->source, message->translated.front()));
  }
  for (Phrases* phrases : {&core_, &errors_})
    std::stable_sort(phrases->begin(), phrases->end(), [](const Phrase& a, const Phrase& b) {
      return a.form.pattern().size() > b.form.pattern().size();
    });
}

Translation::Phrase Translation::phrase_of(const QString& source, const QString& translated) {
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
  return phrase;
}

/// Numbers within what is put in as this language writes them; what is no number alone (a name, a path) stays.
static QString with_mark(QString put_in) {
  static const QRegularExpression number("^[+\\-−±0-9.e ]+( ?(px|mm|m|rad|mrad|deg|degrees|kg|s|N m|N|%|sigma))?$"),
      point("(\\d)\\.(\\d)");
  if (number.match(put_in).hasMatch()) put_in.replace(point, QString("\\1") + widgets::decimal_mark() + "\\2");
  return put_in;
}

/// What takes a place. In an error it may be the name of an element or a file, which stays what it is: only what is
/// said of files is translated.
QString Translation::of_place(const QString& put_in, bool is_error) const {
  const auto whole = forms_.find(put_in);
  const bool is_said = !is_error || sources_[errors].contains(put_in) || sources_[system].contains(put_in);
  return whole != forms_.end() && is_said ? whole->front() : phrase(put_in, is_error);
}

QString Translation::put_together(const Phrase& phrase, const QRegularExpressionMatch& match, bool is_error) const {
  QString text;
  for (qsizetype at = 0; at < phrase.translated.size(); ++at) {
    const qsizetype place = phrase.places.indexOf(phrase.translated.mid(at, 2));
    if (place < 0) {
      text += phrase.translated[at];
      continue;
    }
    const QString put_in = match.captured(static_cast<int>(place) + 1), known = of_place(put_in, is_error);
    text += known.isEmpty() ? with_mark(put_in) : known;
    ++at;
  }
  return text;
}

/// Empty: none has that form.
QString Translation::phrase(const Phrases& phrases, const QString& source, bool is_error) const {
  for (const Phrase& p : phrases) {
    if (!source.startsWith(p.begin)) continue;
    const auto match = p.form.match(source);
    if (match.hasMatch()) return put_together(p, match, is_error);
  }
  return {};
}

QString Translation::phrase(const QString& source, bool is_error) const {
  const QString of_core = phrase(core_, source, is_error);
  return of_core.isEmpty() && is_error ? phrase(errors_, source, is_error) : of_core;
}

QString Translation::translate(const char* context, const char* source, const char*, int n) const {
  const QString text = QString::fromUtf8(source);
  const auto found = forms_.find(text);
  if (found != forms_.end()) return n >= 0 && n != 1 ? found->back() : found->front();
  const bool is_error = qstrcmp(context, errors) == 0;
  return is_error || qstrcmp(context, core) == 0 ? phrase(text, is_error) : QString();
}

QStringList languages() { return {"de"}; }

void speak(QCoreApplication& application, const QString& language) {
  const QString wanted = language.isEmpty() ? QLocale::system().name().section('_', 0, 0) : language;
  if (!languages().contains(wanted)) return;
  application.installTranslator(new Translation(wanted));
  //: what parts the whole from its decimals in a number
  const QString mark = QCoreApplication::translate("QObject", "decimal point");
  if (mark.size() == 1) widgets::set_decimal_mark(mark[0]);
}

}  // namespace handsight::app
