% read_export.m FILE NUMBERS: whether Octave reads of an export what the test wrote.
names = argv();
r = load(names{1});
file = fopen(names{2});
found = {r.module.device_t_s, r.module.current_a, r.loadcell.force_n, r.table.torque_nm};
for i = 1:4
  count = fread(file, 1, 'double');
  assert(isequaln(fread(file, count, 'double'), found{i}(:)));
end
if isfield(r, 'units')  % MATLAB's own format carries them as a struct, HDF5 as attributes
  assert(strcmp(r.units.loadcell.force_n, 'N'));
  assert(strfind(r.provenance.facts, 'searig-export/1') > 0);
end
