// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QLocale>
#include <QXmlStreamReader>
#include <optional>

#include "widgets/base/number_text.h"

/// Outside of any namespace, as the macro wants it: the texts lie in a static library.
static void init_translations() { Q_INIT_RESOURCE(translations); }

namespace handsight::app {
namespace {

void make_ready() {
  static const bool is_ready = (init_translations(), true);
  static_cast<void>(is_ready);
}

/// One <message>: its source and the forms of its translation; nothing where it has none.
struct Entry {
  QString source;
  QStringList translated;
};

std::optional<Entry> read_entry(QXmlStreamReader& xml) {
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
  return Entry{source, translated};
}

}  // namespace

Translation::Translation(const QString& language) {
  make_ready();
  QFile file(QString(":/translations/%1.ts").arg(language));
  if (!file.open(QIODevice::ReadOnly)) return;
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() != QLatin1String("message")) continue;
    const auto entry = read_entry(xml);
    if (!entry) continue;
    sources_[context] << entry->source;
    forms_[entry->source] = entry->translated;
  }
}

QString Translation::translate(const char*, const char* source, const char*, int n) const {
  const auto found = forms_.find(QString::fromUtf8(source));
  if (found == forms_.end()) return {};
  return n >= 0 && n != 1 ? found->back() : found->front();
}

QStringList languages() {
  make_ready();
  QStringList names;
  for (const QString& file : QDir(":/translations").entryList({"*.ts"}, QDir::Files, QDir::Name))
    names << file.section('.', 0, 0);
  return names;
}

void speak(QCoreApplication& application, const QString& language) {
  const QString wanted = language.isEmpty() ? QLocale::system().name().section('_', 0, 0) : language;
  const bool is_known = languages().contains(wanted);
  QLocale locale(is_known ? wanted : QStringLiteral("en"));  // of fields with numbers, and of dates
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  QLocale::setDefault(locale);
  if (!is_known) return;
  auto* translation = new Translation(wanted);
  translation->setParent(&application);
  application.installTranslator(translation);
  //: what parts the whole from its decimals in a number
  const QString mark = QCoreApplication::translate("QObject", "decimal point");
  if (mark.size() == 1) widgets::set_decimal_mark(mark[0]);
}

}  // namespace handsight::app
