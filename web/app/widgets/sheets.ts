// Sheets that lie over the page: each closes when the focus goes elsewhere.

export function closeLeftSheets(): void {
  document.addEventListener('focusin', ({ target }) => {
    const sheet = document.querySelector<HTMLElement>('.sheet:popover-open');
    if (!sheet || !(target instanceof Element) || sheet.contains(target)) return;
    // The focus goes from a sheet's opener into the sheet.
    if (target.getAttribute('popovertarget') !== sheet.id) sheet.hidePopover();
  });
}
