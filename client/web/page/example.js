// What a page does with <aucast-player>: show() and nothing more.
const face = document.getElementById('face');
const shown = document.getElementById('shown');
for (const button of document.querySelectorAll('[data-aus]')) {
  button.addEventListener('click', async () => {
    await face.show(button.dataset.aus);
    shown.textContent = face.aus;
  });
}
