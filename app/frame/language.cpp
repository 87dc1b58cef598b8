// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame/language.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QXmlStreamReader>

/// Outside of any namespace, as the macro wants it: the texts lie in a static library.
static void init_translations() { Q_INIT_RESOURCE(translations); }

namespace handsight::app {
namespace {

/// One <message>: its source and the forms of its translation.
void read_message(QXmlStreamReader& xml, QHash<QString, QStringList>& forms) {
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
  if (!source.isEmpty() && !translated.isEmpty() && !translated.front().isEmpty()) forms[source] = translated;
}

}  // namespace

Translation::Translation(const QString& language) {
  static const bool is_ready = (init_translations(), true);
  QFile file(QString(":/translations/%1.ts").arg(language));
  if (!is_ready || !file.open(QIODevice::ReadOnly)) return;
  QXmlStreamReader xml(&file);
  while (!xml.atEnd())
    if (xml.readNext() == QXmlStreamReader::StartElement && xml.name() == QLatin1String("message"))
      read_message(xml, forms_);
}

QString Translation::translate(const char*, const char* source, const char*, int n) const {
  const auto found = forms_.find(QString::fromUtf8(source));
  if (found == forms_.end()) return {};
  return n >= 0 && n != 1 ? found->back() : found->front();
}

QStringList languages() { return {"de"}; }

void speak(QCoreApplication& application, const QString& language) {
  const QString wanted = language.isEmpty() ? QLocale::system().name().section('_', 0, 0) : language;
  if (!languages().contains(wanted)) return;
  application.installTranslator(new Translation(wanted));
}

}  // namespace handsight::app
