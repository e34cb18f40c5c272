#include "speaker/espeak_voice.h"

#include <espeak-ng/speak_lib.h>

#include <array>
#include <cstring>

#include "common/text.h"

namespace aucast::speaker {
namespace {

/// The library's callback adds to this, since it gets no pointer of ours.
Speech* g_speech = nullptr;

Milliseconds at(const espeak_EVENT& event) {
  return Milliseconds(event.audio_position);
}

void take_event(const espeak_EVENT& event, Speech& speech) {
  switch (event.type) {
    case espeakEVENT_PHONEME: {
      // Eight bytes that need not end in a zero.
      std::array<char, sizeof(event.id.string) + 1> name{};
      std::memcpy(name.data(), event.id.string, sizeof(event.id.string));
      speech.phonemes.push_back({name.data(), at(event)});
      break;
    }
    case espeakEVENT_WORD:
      if (event.length > 0) {
        speech.words.push_back({at(event), static_cast<std::size_t>(event.text_position - 1),
                                static_cast<std::size_t>(event.length)});
      }
      break;
    case espeakEVENT_END:
      speech.sentence_ends.push_back(at(event));
      break;
    default:
      break;
  }
}

int take(short* samples, int count, espeak_EVENT* event) {
  constexpr float kFullScale = 32768;
  if (samples != nullptr) {
    for (int i = 0; i < count; ++i) {
      g_speech->samples.push_back(static_cast<float>(samples[i]) / kFullScale);
    }
  }
  for (; event->type != espeakEVENT_LIST_TERMINATED; ++event) take_event(*event, *g_speech);
  return 0;
}

/// Initialised once in a process: after a second time, espeak-ng 1.51 hangs in the first words.
class Library {
 public:
  Library()
      : rate_(espeak_Initialize(AUDIO_OUTPUT_SYNCHRONOUS, 200, nullptr,
                                espeakINITIALIZE_PHONEME_EVENTS | espeakINITIALIZE_PHONEME_IPA |
                                    espeakINITIALIZE_DONT_EXIT)) {}
  ~Library() {
    if (rate_ > 0) espeak_Terminate();
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  /// Samples a second.
  [[nodiscard]] Result<int> rate() const {
    if (rate_ > 0) return rate_;
    return Error{ErrorKind::Failed,
                 "espeak-ng cannot be started: is its data installed? (package espeak-ng-data)"};
  }

 private:
  int rate_;
};

const Library& library() {
  static const Library the_library;
  return the_library;
}

/// Of successive pauses, only the first is kept.
void join_pauses(std::vector<Phoneme>& phonemes) {
  std::vector<Phoneme> joined;
  for (Phoneme& phoneme : phonemes) {
    if (phoneme.ipa.starts_with('_')) phoneme.ipa.clear();
    const bool second = phoneme.ipa.empty() && !joined.empty() && joined.back().ipa.empty();
    if (!second) joined.push_back(std::move(phoneme));
  }
  phonemes = std::move(joined);
}

}  // namespace

Result<Speech> speak(const std::string& text, const VoiceOptions& options) {
  const auto rate = library().rate();
  if (!rate) return rate.error();
  // The library knows voices by name and by language, and does not try both.
  espeak_VOICE wanted{};
  wanted.languages = options.language.c_str();
  if (espeak_SetVoiceByName(options.language.c_str()) != EE_OK &&
      espeak_SetVoiceByProperties(&wanted) != EE_OK) {
    return Error{ErrorKind::Usage, "espeak-ng has no voice '" + escaped(options.language) +
                                       "'; --list-voices names them"};
  }
  espeak_SetParameter(espeakRATE, options.words_per_minute, 0);
  espeak_SetParameter(espeakPITCH, options.pitch, 0);
  Speech speech;
  speech.rate = *rate;
  g_speech = &speech;
  espeak_SetSynthCallback(take);
  const espeak_ERROR result = espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0,
                                           espeakCHARS_UTF8 | espeakENDPAUSE, nullptr, nullptr);
  espeak_Synchronize();
  g_speech = nullptr;
  if (result != EE_OK || speech.samples.empty()) {
    return Error{ErrorKind::Failed, "espeak-ng could not speak the text"};
  }
  join_pauses(speech.phonemes);
  return speech;
}

Result<std::vector<std::string>> voices() {
  if (const auto rate = library().rate(); !rate) return rate.error();
  std::vector<std::string> names;
  for (const espeak_VOICE** voice = espeak_ListVoices(nullptr); *voice != nullptr; ++voice) {
    // A byte of priority stands before the language.
    names.push_back(std::string((*voice)->languages + 1) + "\t" + (*voice)->name);
  }
  return names;
}

}  // namespace aucast::speaker
