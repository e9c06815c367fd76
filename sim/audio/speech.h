#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "sim/audio/ssip.h"

namespace moontrace {

/// Speech through speech-dispatcher. Every call returns at once: a thread of its own talks to the
/// service, from a queue that never grows past 64 sentences. A service that is not there, dies or
/// does not answer costs one sentence (TakeSentence) and then nothing more is spoken: text is what
/// counts.
class Speech {
 public:
  /// Begins to connect: to $SPEECHD_ADDRESS ("unix_socket:PATH"), otherwise to the user's service,
  /// which is started if need be. Never throws.
  explicit Speech(const SpeechOptions& options);
  /// What is still in the queue gets at most 0.2 s to be handed over.
  ~Speech();
  Speech(const Speech&) = delete;
  Speech& operator=(const Speech&) = delete;

  void Say(Priority priority, std::string_view text);
  /// A word, letter by letter; as text.
  void Spell(std::string_view word);
  /// One character by its name: "comma", "capital a"; as text.
  void Character(std::string_view character);
  /// Silence at once, for any key and for a lifted stylus; drops what waits but kImportant.
  void Cancel();
  /// -100 to 100, held to that; from the next sentence on.
  void SetRate(int rate);

  /// Why nothing is spoken any more: one sentence, once.
  std::optional<std::string> TakeSentence();
  /// The service has answered and nothing went wrong since.
  bool speaking() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace moontrace
