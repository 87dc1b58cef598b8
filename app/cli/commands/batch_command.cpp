// SPDX-License-Identifier: Apache-2.0
// Many sessions, each in a process of its own: what goes wrong in one is its line and nobody else's.
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <iostream>
#include <map>

#include "base/text.h"
#include "base/threads.h"
#include "command.h"
#include "diagnosis/selection/improvement.h"
#include "diagnosis/verdict/diagnosis.h"
#include "printing/outputs.h"
#include "session/collection.h"
#include "session/session_xml.h"

namespace handsight::cli {
namespace {

struct BatchArguments {
  std::vector<std::string> sessions;
  std::string csv = "-";
  int jobs = 1;
  bool improves = false;
};

constexpr char header[] =
    "session,state,observations,used,noise,rms,held_out,unit,chi2_per_dof,verdict,best,where,ln_bayes_factor,reason\n";

std::string field(const std::string& text) {
  std::string line = shortened(text, 2000);
  if (line.find_first_of(",\"") == std::string::npos) return line;
  std::string out = "\"";
  for (const char c : line) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string number_text(const std::optional<double>& x) { return x ? fmt::format("{:.9g}", *x) : ""; }

std::string failure(const std::string& session, const std::string& why) {
  return fmt::format("{},failed,,,,,,,,,,,,{}\n", field(session), field(why));
}

std::string diagnosis_line(const std::string& path, const Diagnosis& d, const Session& session) {
  const FitReport& r = d.report;
  const bool in_pixels = !session.is_tracker();
  const DiagnosisCandidate* const best =
      d.candidates.empty() || d.candidates.front().ln_bayes_factor < d.threshold ? nullptr : &d.candidates.front();
  std::string where;
  for (const std::string& w : best ? best->where : std::vector<std::string>()) where += (where.empty() ? "" : " ") + w;
  return fmt::format("{},done,{},{},{},{},{},{},{},{},{},{},{},{}\n", field(path), r.observations, r.used,
                     number_text(d.noise), number_text(in_pixels ? r.fitted.rms_pixel : r.fitted.rms_m),
                     number_text(in_pixels ? r.held_out.rms_pixel : r.held_out.rms_m), in_pixels ? "px" : "m",
                     number_text(d.model.fit.chi2_per_dof), verdict_text(d.verdict),
                     best ? (best->unnamed ? "unnamed" : field(best->id)) : "", field(where),
                     best ? fmt::format("{:.4g}", best->ln_bayes_factor) : "", field(d.reason));
}

std::string find_line(const std::string& path, bool improves) {
  try {
    const Session session = is_collection(path) ? open_session(path) : read_session(path);
    ImprovementOptions options;
    options.with_choosing = false;
    if (improves) return diagnosis_line(path, improve(session, options).last, session);
    return diagnosis_line(path, diagnose(session), session);
  } catch (const InputError& error) {
    return failure(path, error.what());
  } catch (const std::bad_alloc&) {
    return failure(path, "there is not enough memory for this session");
  } catch (const std::exception& error) {
    return failure(path, std::string("an error of the program: ") + error.what());
  }
}

void write_all(int to, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t n = write(to, text.data() + at, text.size() - at);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return;
    at += static_cast<std::size_t>(n);
  }
}

/// A running job: where its line comes from.
struct Job {
  pid_t process = 0;
  std::string text;
  std::size_t place = 0;
};

class Runner {
 public:
  explicit Runner(const BatchArguments& o) : o_(o), lines_(o.sessions.size()) {}

  std::vector<std::string> run() {
    Progress progress("sessions", o_.sessions.size());
    while (done_ < o_.sessions.size()) {
      while (static_cast<int>(jobs_.size()) < o_.jobs && next_ < o_.sessions.size()) start();
      read_some();
      progress.at(done_);
    }
    return std::move(lines_);
  }

 private:
  void start() {
    int ends[2];
    if (pipe(ends) != 0) throw InputError("No more processes can be started; name fewer with --jobs.");
    const pid_t process = fork();
    if (process < 0) throw InputError("No more processes can be started; name fewer with --jobs.");
    if (process == 0) {
      close(ends[0]);
      most_threads() = 1;  // as many cores as jobs, whoever else computes
      write_all(ends[1], find_line(o_.sessions[next_], o_.improves));
      _exit(0);
    }
    close(ends[1]);
    jobs_[ends[0]] = {process, "", next_++};
  }

  void read_some() {
    std::vector<pollfd> waiting;
    for (const auto& [from, job] : jobs_) waiting.push_back({from, POLLIN, 0});
    if (poll(waiting.data(), waiting.size(), -1) < 0) return;
    for (const pollfd& p : waiting) {
      if (p.revents == 0) continue;
      char bytes[4096];
      const ssize_t n = read(p.fd, bytes, sizeof bytes);
      if (n > 0)
        jobs_[p.fd].text.append(bytes, static_cast<std::size_t>(n));
      else
        finish(p.fd);
    }
  }

  void finish(int from) {
    Job& job = jobs_[from];
    int status = 0;
    waitpid(job.process, &status, 0);
    const std::string& session = o_.sessions[job.place];
    lines_[job.place] = WIFSIGNALED(status)
                            ? failure(session, fmt::format("the program ended by signal {} ({})", WTERMSIG(status),
                                                           strsignal(WTERMSIG(status))))
                        : job.text.empty() ? failure(session, "the program ended without an answer")
                                           : job.text;
    close(from);
    jobs_.erase(from);
    ++done_;
  }

  const BatchArguments& o_;
  std::vector<std::string> lines_;  // in the order of the sessions, whoever ends first
  std::map<int, Job> jobs_;         // by the end of their pipe
  std::size_t next_ = 0, done_ = 0;
};

int run(const BatchArguments& o) {
  require_output(o.csv, "--csv");
  std::cout.flush();
  std::string table = header;
  std::size_t failed = 0;
  const std::vector<std::string> lines = Runner(o).run();
  for (const std::string& line : lines) {
    table += line;
    failed += line.find(",failed,") != std::string::npos;
  }
  if (o.csv == "-") {
    std::cout << table;
  } else {
    write_output(o.csv, table, "--csv");
    Output{}.line(fmt::format("{} sessions, {} of them failed; written: {}", o.sessions.size(), failed, o.csv));
  }
  return failed == o.sessions.size() ? wrong_input : done;
}

}  // namespace

Command add_batch(const CommandLine& program) {
  auto options = std::make_shared<BatchArguments>();
  const CommandLine command =
      program.command("batch", "Fits and diagnoses many sessions, a line each; a failure is a line too");
  command.option("SESSION", options->sessions, "Sessions: folders or session.xml files").required();
  command.option("--jobs", options->jobs, "How many at once; the results do not depend on it").from_to(1, 1024);
  command.option("--csv", options->csv, "The table to write; - is standard output");
  command.flag("--improve", options->improves, "Improve each model first; the verdict is of what is left");
  return {command, [options] { return run(*options); }};
}

}  // namespace handsight::cli
