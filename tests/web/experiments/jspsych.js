// Is the smile enjoyed? One face for all trials: it is loaded once.
const face = document.createElement('aucast-player');
const place = '<div class="face"></div>';
const jsPsych = initJsPsych({ on_finish: () => { window.results = jsPsych.data.get().values(); } });

const loading = {
  type: jsPsychHtmlKeyboardResponse,
  stimulus: place,
  choices: 'NO_KEYS',
  on_load: async () => {
    document.querySelector('.face').append(face);
    await face.ready;
    jsPsych.finishTrial();
  },
};

let onset;
const trial = {
  type: jsPsychHtmlKeyboardResponse,
  stimulus: place,
  prompt: '<p>Is the smile enjoyed? <kbd>j</kbd> yes, <kbd>n</kbd> no</p>',
  choices: ['j', 'n'],
  data: { aus: jsPsych.timelineVariable('aus') },
  on_load: async () => {
    document.querySelector('.face').append(face);
    await face.show(jsPsych.evaluateTimelineVariable('aus'));
    requestAnimationFrame(time => { onset = time; });
  },
  on_finish: data => { data.onset = onset; },
};

// A stream of a server, with the time at which each of its keyframes began.
const onsets = [];
const stream = {
  type: jsPsychHtmlKeyboardResponse,
  stimulus: place,
  choices: 'NO_KEYS',
  on_load: () => {
    document.querySelector('.face').append(face);
    face.addEventListener('keyframe', ({ detail, timeStamp }) => {
      onsets.push({ aus: detail.aus, onset: timeStamp });
    });
    face.addEventListener('state', ({ detail }) => {
      if (detail.state === 'ended') jsPsych.finishTrial();
    });
    face.setAttribute('server', new URLSearchParams(location.search).get('server'));
  },
  on_finish: data => { data.onsets = onsets; },
};

jsPsych.run([loading, {
  timeline: [trial],
  timeline_variables: [{ aus: '12' }, { aus: '6,12:80' }, { aus: '0' }],
}, stream]);
