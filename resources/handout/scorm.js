// Tells a learning platform (SCORM 1.2) which parts were seen, how long it took, when all of them were, and the points of
// the exercises. The platform offers its object "API" in a frame or window around the page; without one nothing is told.

const sheet = document.getElementById('exercises');
const PARTS = ['drawings', 'matrices', 'solution', 'derivation'].filter(part => document.getElementById(part)).concat(sheet ? ['exercises'] : []);
const FARTHEST = 10;  // frames outwards, as the standard has it

// Frames of another origin may not be looked into.
const apiOf = frame => {
  try {
    return frame.API || null;
  } catch (error) {
    return null;
  }
};
const apiAround = start => {
  for (let frame = start, steps = 0; frame && steps < FARTHEST; frame = frame.parent, ++steps) {
    const api = apiOf(frame);
    if (api) return api;
    if (frame === frame.parent) return null;
  }
  return null;
};
const api = apiAround(window) || (window.opener ? apiAround(window.opener) : null);

// HHHH:MM:SS.SS
const timeText = milliseconds => {
  const hundredths = Math.round(milliseconds / 10);
  const two = number => String(number).padStart(2, '0');
  const seconds = Math.floor(hundredths / 100);
  return String(Math.floor(seconds / 3600)).padStart(4, '0') + ':' + two(Math.floor(seconds / 60) % 60) + ':' +
         two(seconds % 60) + '.' + two(hundredths % 100);
};

if (api && String(api.LMSInitialize('')) === 'true') {
  const begun = Date.now();
  const seen = new Set(String(api.LMSGetValue('cmi.suspend_data') || '').split(',').filter(part => PARTS.includes(part)));
  const tell = () => {
    const status = api.LMSGetValue('cmi.core.lesson_status');
    const isOver = PARTS.every(part => seen.has(part));
    if (isOver ? status !== 'completed' : status !== 'completed' && status !== 'incomplete')
      api.LMSSetValue('cmi.core.lesson_status', isOver ? 'completed' : 'incomplete');
    api.LMSSetValue('cmi.suspend_data', PARTS.filter(part => seen.has(part)).join(','));
    api.LMSCommit('');
  };
  // In percent; what was reached on another day or device stays.
  const tellPoints = () => {
    if (!sheet.dataset.of) return;
    const before = Number(api.LMSGetValue('cmi.core.score.raw') || 0);
    const score = Math.max(before, Math.round(100 * Number(sheet.dataset.points) / Number(sheet.dataset.of)));
    for (const [name, value] of [['min', 0], ['max', 100], ['raw', score]])
      api.LMSSetValue('cmi.core.score.' + name, String(value));
    if (sheet.dataset.open === '0') seen.add('exercises');
    tell();
  };
  if (sheet) {
    sheet.addEventListener('points', tellPoints);
    tellPoints();
  }
  const observer = new IntersectionObserver(entries => {
    const before = seen.size;
    for (const {isIntersecting, target} of entries) if (isIntersecting) seen.add(target.id);
    if (seen.size > before) tell();
  });
  // Exercises are over when each was checked or shown, not when they were seen.
  for (const part of PARTS) if (part !== 'exercises') observer.observe(document.getElementById(part));
  tell();
  let isFinished = false;
  window.addEventListener('pagehide', () => {
    if (isFinished) return;
    isFinished = true;
    api.LMSSetValue('cmi.core.session_time', timeText(Date.now() - begun));
    tell();
    api.LMSFinish('');
  });
}
