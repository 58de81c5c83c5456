/// What other sites show beside a link to the page: its picture and its address. Most take no relative ones, so `site`
/// says where the page will stand (https://host/path/); where it is '' nobody knows, and the picture's address stays
/// relative.
export function card(site: string): string {
  const meta = (name: string, content: string): string => `<meta property="og:${name}" content="${content}">`;
  if (site === '') return meta('image', './social-card.png');
  const folder = folderOf(site);
  return `${meta('image', new URL('social-card.png', folder).href)}\n    ${meta('url', folder.href)}`;
}

function folderOf(site: string): URL {
  const address = site.endsWith('/') ? site : `${site}/`;
  const folder = URL.canParse(address) ? new URL(address) : null;
  if (!folder || !/^https?:$/.test(folder.protocol) || folder.search || folder.hash)
    throw new Error(`KNOTWORK_SITE_ADDRESS: "${site}" is no address of a site, as https://host/path/`);
  return folder;
}
