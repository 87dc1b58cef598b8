// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/report_story.h"

#include "document/curve_words.h"
#include "findings/bill_entries.h"
#include "findings/explain_texts.h"
#include "words/core_words.h"

namespace handsight::app {
namespace {

QString name_of_lead(const Workbench& workbench, const Story& story, const ModelVersionPointer& model) {
  const auto diagnosis = workbench.find_diagnosis(model);
  if (!diagnosis || story.causes.empty()) return {};
  return display_name(diagnosis->candidates[story.causes.front().candidate], workbench.document.session());
}

QString next_text(const Story& story, const QString& lead) {
  switch (story.next) {
    case StoryNext::measure_more:
      return QObject::tr("Next: measure more observations.");
    case StoryNext::tell_apart:
      return QObject::tr("Next: measure poses that tell the two apart; Explain plans them.");
    case StoryNext::add:
      return QObject::tr("Next: add %1 to the model.").arg(lead);
    case StoryNext::add_or_stop:
      return QObject::tr("Next: look for another cause; %1 would lower the error, but may stand in for it.").arg(lead);
    case StoryNext::tell_the_noise:
      return QObject::tr("Next: declare the noise (sigma), or repeat some poses.");
    case StoryNext::give_masses:
      return QObject::tr("Next: give the links' masses in the robot's file; nothing that bends could be tried.");
    case StoryNext::look:
      return QObject::tr("Next: look at what is left and at what it follows.");
    case StoryNext::use_it:
      return QObject::tr("Next: use it. The numbers stand below and in the XML.");
    case StoryNext::wait:
      break;
  }
  return {};
}

}  // namespace

ReportStory report_story(const Workbench& workbench, const ModelVersionPointer& model) {
  const Story& story = workbench.find_story(model);
  const widgets::SessionVerdict verdict = session_verdict(workbench, model);
  const std::vector<Blunder>& blunders = workbench.blunders();
  const QString next = blunders.empty() ? next_text(story, name_of_lead(workbench, story, model))
                                        : QObject::tr("Next: %1").arg(translated(blunders.front().fix));
  return {verdict.sentence, verdict.figures, next, bill_entries(workbench, model)};
}

}  // namespace handsight::app
