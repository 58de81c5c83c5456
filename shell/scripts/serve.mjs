// Serves dist. PORT overrides 8080; loopback only; Ctrl+C ends it.
import { join } from 'node:path';
import { dist } from './files.mjs';
import { serve, sizeOf } from './static.mjs';

const port = Number(process.env.PORT ?? 8080);
if (!(await sizeOf(join(dist, 'index.html')))) {
  console.error('There is nothing to serve yet: run npm run build first.');
  process.exit(1);
}
try {
  const server = await serve(dist, port);
  console.log(`Knotwork is at http://localhost:${server.address().port}/ (Ctrl+C ends it)`);
  for (const signal of ['SIGINT', 'SIGTERM']) {
    process.on(signal, () => {
      server.close(() => process.exit(0));
      server.closeAllConnections();
    });
  }
} catch (error) {
  console.error(error.code === 'EADDRINUSE' ? `Port ${port} is in use: set PORT to another one.` : error.message);
  process.exit(1);
}
