// Asks for the token of a server that plays only to those who have it. It is kept in memory alone.

const TOKEN = /^[!-z|~]{1,256}$/;  // as the protocol has it: no blank, no brace

export class TokenForm {
  constructor(player) {
    this.player = player;
    this.form = document.createElement('form');
    this.form.className = 'token';
    this.form.hidden = true;
    const label = document.createElement('label');
    label.textContent = 'Token ';
    this.field = document.createElement('input');
    this.field.type = 'password';
    this.field.required = true;
    this.field.autocomplete = 'off';
    this.field.setAttribute('aria-describedby', player.message.id);
    label.append(this.field);
    const button = document.createElement('button');
    button.textContent = 'Play';
    this.form.append(label, button);
    this.form.addEventListener('submit', event => this.submit(event));
    this.form.addEventListener('keydown', event => {
      if (event.key === 'Escape') this.close();
    });
    player.message.after(this.form);
  }

  get shown() { return !this.form.hidden; }

  /// After each change of the state. While the token is tried, the form stays.
  follow(state) {
    const { player } = this;
    if (player.wantsToken && player.engine.maySendToken) {
      this.field.setAttribute('aria-invalid', String(player.token !== ''));
      this.form.hidden = false;
      // Who writes elsewhere in the page is left there.
      if ([document.body, player, null].includes(document.activeElement)) {
        this.field.focus({ preventScroll: true });
      }
    } else if (this.shown && state !== 'connecting') {
      this.close();
    }
  }

  submit(event) {
    event.preventDefault();
    const token = this.field.value.trim();
    this.field.value = '';
    if (!TOKEN.test(token)) {
      this.field.setAttribute('aria-invalid', 'true');
      this.player.say('This is no token. Ask the lecturer for it.');
      return;
    }
    this.player.token = token;
    this.player.playAgain().catch(error => this.player.fail(error));
  }

  close() {
    const focused = this.form.contains(this.player.shadowRoot.activeElement);
    this.field.value = '';
    this.form.hidden = true;
    if (focused) this.player.canvas.focus({ preventScroll: true });
    this.player.controls.showPause();
  }
}
