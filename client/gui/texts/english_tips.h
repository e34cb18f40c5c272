#pragma once

#include <array>

#include "client/gui/texts/english_text.h"

namespace aucast::gui {

/// The tooltips of words and controls.
inline constexpr std::array kEnglishTips = std::to_array<EnglishText>({
    {"tip.au",
     "Action Unit: a movement of the face that FACS (2002) names by a number, such as 12, the "
     "corners of the lips pulled up"},
    {"tip.au_received", "what came: the AUs of the keyframe that the face is moving to"},
    {"tip.au_shown",
     "what the face shows at this moment. It can differ from what was received in three cases: the "
     "face is still on its way to the keyframe (interpolation), a rule has changed the AU (said "
     "below its name), or this face does not have the AU. Mixer, blinks and idle movements come "
     "after this."},
    {"tip.rule",
     "The AUs before and after a rule. Opposition: of two that undo each other, only the "
     "difference "
     "is left. Alternative: the largest stays. Exclusion: one keeps another away. Cap: one limits "
     "another to a fixed intensity. Substitution: several give way to one. Dominance: the stronger "
     "one is, the less of another is left."},
    {"tip.au_asked", "as it was typed, or as the expression has it"},
    {"tip.au_blended",
     "what the face shows in the end: a rule that changed an AU is said below its name. The mixer "
     "comes after this."},
    {"tip.receiver",
     "the Receiver buffer: sets of AUs as they came, against the jitter of a network (what comes "
     "late or in bursts); the mark is the threshold"},
    {"tip.playout", "the Playout buffer: the sets that are about to be played"},
    {"tip.buffer", "how many sets the Receiver buffer holds"},
    {"tip.threshold", "how full the buffer must be before playing begins, and again after a stall"},
    {"tip.last_30",
     "how full the Receiver buffer was; at the bottom nothing is left to play and the face stalls: "
     "an underrun"},
    {"tip.delay", "how long a live keyframe waits before it is played, so that jitter is not seen"},
    {"tip.protocol",
     "classic is level 1, the protocol of the thesis; level 2 has intensities, sides and times"},
    {"tip.address",
     "where the au-transmitter is: HOST, HOST:PORT or aucast://HOST/STREAM; aucasts:// is over "
     "TLS"},
    {"tip.tls",
     "Transport Layer Security: what is sent can be neither read nor changed on its way"},
    {"tip.authorities",
     "a file (PEM) with the authorities to trust in place of the system's, as --tls-ca names"},
    {"tip.token", "a file with the secret that the server asks for"},
    {"tip.again", "the server is tried again until it is there"},
    {"tip.mixer",
     "what AUs that move the same muscle make of it together: the strongest counts (maximum), or "
     "all of them (average)"},
    {"tip.rules",
     "co-occurrence rules: how AUs act on each other, such as 51 and 52, of which a face shows "
     "one"},
    {"tip.in_between",
     "interpolation: from one keyframe to the next evenly, or with a soft beginning and end"},
    {"tip.pad", "Space, then the arrows, moves the face between the emotions"},
    {"tip.pad_held", "the arrows move the face; Space ends that"},
    {"tip.seek_bar", "Space, then Left and Right: 1 s, Up and Down: 10 s"},
    {"tip.curves", "Space, then Left and Right go by frames of video, Up and Down from AU to AU"},
    {"tip.keyframe", "a set of AUs and the time in which the face reaches it"},
    {"tip.neutral", "the neutral face: no AU and no muscle"},
    {"tip.macros", "muscles contracted directly, without AUs, as in the program of Waters (1987)"},
    {"tip.muscles", "contraction: 0 is at rest"},
    {"tip.frames",
     "how many pictures lead from the present face to the expression; their number times the time "
     "of each is how long the transition lasts"},
    {"tip.seed", "the same number gives the same blinks again"},
    {"tip.landmarks", "the points of the face that the recogniser has found"},
    {"tip.textured", "the skin with its colours"},
    {"tip.wireframe", "the edges of the triangles that the face is made of"},
    {"tip.polygons", "the triangles in one plain colour"},
    {"tip.vertices", "the corners of the triangles"},
    {"tip.transparent", "what is behind the skin is seen through it"},
    {"tip.muscle_lines",
     "each muscle from its origin in the bone to its insertion in the skin (Waters 1987)"},
    {"tip.jaw_tags", "the vertices that the jaw carries, coloured by how much of its way they go"},
    {"tip.eye_tags", "the vertices of the eyelids, coloured by how far they go"},
    {"tip.camera",
     "'camera' is the first camera, 'camera:DEVICE' another one; 'camera:FILM' plays a film in "
     "place of a camera"},
    {"tip.film", "a film in place of a camera"},
    {"tip.film_live", "starts the film, and others can watch it from its beginning"},
    {"tip.live", "who watches sees your face of this moment"},
    {"tip.admission", "--token-file, --tls-cert and --tls-key on the command line decide"},
    {"tip.behind",
     "how far the face is behind the server. Live: as little as the network allows, at the risk of "
     "stalls. Auto: as much as it needs. Time: so many ms. Sets: until the buffers are as full as "
     "is set below, as in the thesis"},
    {"tip.behind_sets",
     "as in the thesis: it plays once the buffers hold as many sets of AUs as is set below"},
    {"tip.behind_live", "as little as the network allows; where it is late, the face stalls"},
    {"tip.behind_auto", "as much as this network needs, measured while it plays"},
    {"tip.behind_time",
     "always so many milliseconds; where the network is later than that, the face stalls"},
    {"tip.maximum", "of AUs that move the same muscle, the strongest counts"},
    {"tip.average", "AUs that move the same muscle share it: the mean of what they ask for"},
    {"tip.linear", "evenly, at the same speed all the way"},
    {"tip.cosine", "with a soft beginning and a soft end"},
    {"tip.rules_facs",
     "what FACS (2002) says of codes that exclude each other, made soft for intensities"},
    {"tip.rules_kumar", "the table of Kumar (2010) as it was published, to compare with"},
    {"tip.no_rules", "every AU is shown as it came"},
    {"tip.stream", "one of the streams that the server has; the list is asked for as it opens"},
    {"tip.buffers",
     "sets of AUs wait here before they are played, so that a late one does not stop the face"},
    {"tip.received",
     "packets and bytes that came from the server, how many in a second at present, and on "
     "average"},
    {"tip.sent", "what was sent to the server: answers, pauses and questions"},
    {"tip.animation", "how a face is made of AUs, and what it does between two keyframes"},
    {"tip.time", "how long the face takes to reach the keyframe"},
    {"tip.linked", "a side that is moved takes the other one along"},
    {"tip.edit", "the AU whose muscles are set below"},
    {"tip.save_as", "the number of the AU that this becomes; a shipped face is copied first"},
    {"tip.expressions",
     "named sets of AUs; those of the emotions are the prototypes of the literature"},
    {"tip.way", "how the face goes from one expression to the next"},
    {"tip.viewpoint", "where the face is looked at from"},
    {"tip.show", "the layers of the picture, in any combination"},
    {"tip.pace", "how many pictures a second the window shows, and how long one takes"},
    {"tip.blinking",
     "blinks of the face's own, at random times; a stream may have others in AU 45"},
    {"tip.every_ms", "one blink begins in each such span of time, at a random moment of it"},
    {"tip.closing_ms", "how long the lids take to shut; they open more slowly"},
    {"tip.mirror", "your own face, as others see it: AUs are read from the camera's pictures"},
    {"tip.captions",
     "what is said, as text; it comes with the stream or is in a .vtt file beside it"},
    {"tip.level_meter", "of the sound, from 48 dB below the most there can be"},
});

}  // namespace aucast::gui
