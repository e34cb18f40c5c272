#include "speaker/espeak_voice.h"

#include <espeak-ng/speak_lib.h>

#include <array>
#include <cstring>
#include <exception>
#include <span>
#include <utility>

#include "common/text.h"

namespace aucast::speaker {
namespace {

/// What the library's callback adds to.
struct Recording {
  Speech speech;
  std::size_t samples_max = 0;
  bool too_long = false;
  std::exception_ptr failure;  ///< memory ran out
};

/// The callback gets no pointer of ours.
Recording* g_recording = nullptr;

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
      speech.clause_ends.push_back(at(event));
      break;
    default:
      break;
  }
}

void take_samples(std::span<const short> samples, Speech& speech) {
  constexpr float kFullScale = 32768;
  for (const short sample : samples) {
    speech.samples.push_back(static_cast<float>(sample) / kFullScale);
  }
}

/// Nothing is thrown through the library, which is C.
int take(short* samples, int count, espeak_EVENT* event) {
  constexpr int kGoOn = 0;
  constexpr int kStop = 1;
  Recording& recording = *g_recording;
  if (recording.too_long || recording.failure) return kStop;
  try {
    if (samples != nullptr) {
      take_samples({samples, static_cast<std::size_t>(count)}, recording.speech);
    }
    for (; event->type != espeakEVENT_LIST_TERMINATED; ++event) {
      take_event(*event, recording.speech);
    }
  } catch (...) {
    recording.failure = std::current_exception();
    return kStop;
  }
  recording.too_long = recording.speech.samples.size() > recording.samples_max;
  return recording.too_long ? kStop : kGoOn;
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

Result<Speech> speak(const std::string& text, const VoiceOptions& options, Milliseconds longest) {
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
  Recording recording;
  recording.speech.rate = *rate;
  recording.samples_max =
      static_cast<std::size_t>(longest.count()) * static_cast<std::size_t>(*rate) / 1000;
  g_recording = &recording;
  espeak_SetSynthCallback(take);
  const espeak_ERROR result = espeak_Synth(text.c_str(), text.size() + 1, 0, POS_CHARACTER, 0,
                                           espeakCHARS_UTF8 | espeakENDPAUSE, nullptr, nullptr);
  espeak_Synchronize();
  g_recording = nullptr;
  if (recording.failure) std::rethrow_exception(recording.failure);
  if (recording.too_long) {
    return Error{ErrorKind::BadData, "takes more than " + length_text(longest) +
                                         " to speak, the longest that is spoken; cut it into "
                                         "parts"};
  }
  if (result != EE_OK) return Error{ErrorKind::Failed, "espeak-ng could not speak the text"};
  if (recording.speech.words.empty()) {
    return Error{ErrorKind::BadData, "there are no words to speak"};
  }
  join_pauses(recording.speech.phonemes);
  return std::move(recording.speech);
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
