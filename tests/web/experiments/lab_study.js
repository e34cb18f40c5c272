// Is the smile enjoyed? One face for all trials: it is loaded once.
const face = document.createElement('aucast-player');
const place = '<main class="content-vertical-center content-horizontal-center">' +
    '<div class="face"></div></main>';

const loading = new lab.html.Screen({
  content: place,
  messageHandlers: {
    async run() {
      this.options.el.querySelector('.face').append(face);
      await face.ready;
    },
  },
  timeout: 0,
});

const trial = new lab.html.Screen({
  content: place + '<footer><p>Is the smile enjoyed? <kbd>j</kbd> yes, <kbd>n</kbd> no</p></footer>',
  responses: { 'keydown(j)': 'yes', 'keydown(n)': 'no' },
  messageHandlers: {
    // lab.js waits for it, and takes the time after that: time_show is the onset.
    async run() {
      this.options.el.querySelector('.face').append(face);
      await face.show(this.aggregateParameters.aus);
    },
  },
});

const study = new lab.flow.Sequence({
  content: [loading, new lab.flow.Loop({
    template: trial,
    templateParameters: [{ aus: '12' }, { aus: '6,12:80' }, { aus: '0' }],
  })],
});
study.on('end', () => { window.results = study.options.datastore.data; });
study.run();
