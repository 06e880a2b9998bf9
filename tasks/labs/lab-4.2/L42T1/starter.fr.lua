-- TP 4.2. Longueurs en m, temps en s, vitesses en m/s.

-- Exécutée une fois, quand la scène est en place.
-- C'est ici que va ce dont partent les cercles.
function on_load()
  -- Donnez ici sa vitesse à circle1.
end

-- Exécutée à chaque pas ; timestep est la durée du pas.
-- C'est ici que va la façon dont les cercles se déplacent.
function on_update(timestep)
  -- Déplacez circle1 ici : sa nouvelle position est
  -- l'ancienne plus le chemin de ce pas.
end
