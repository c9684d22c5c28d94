// Sheets that lie over the page: each closes when the focus goes elsewhere.

export function closeLeftSheets(): void {
  document.addEventListener('focusin', ({ target }) => {
    const sheet = document.querySelector<HTMLElement>('.sheet:popover-open');
    if (!sheet || !(target instanceof Element) || sheet.contains(target)) return;
    // From its opener the focus goes into it.
    if (target.getAttribute('popovertarget') !== sheet.id) sheet.hidePopover();
  });
}
